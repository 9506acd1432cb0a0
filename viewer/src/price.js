export function pricePage() {}
