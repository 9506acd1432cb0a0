"""Who notices what: the faults of a run, build/reports/defects.md and defects.csv."""
from tried import CASES, CASES_OF_ALL

NEEDS = ("metamorphic", "proof", "oracle")
# Of one class: how many laws may kill a defect that is to speak for each of them.
FEW = 5


def killers_of(config, result, needs):
    return [law for law in result["laws"] if result["laws"][law] and config.law_needs[law] == needs]


def faults_of_patches(config, patches, results):
    """A defect that survives, or that the law named for it does not notice."""
    out = []
    for patch in patches:
        result = results[patch.name]
        if result["error"]:
            out.append(f"{patch.name}: {result['error']}")
        elif not any(result["laws"].values()):
            out.append(f"{patch.name} survives: no law notices that {patch.defect}")
        elif not result["laws"].get(patch.law):
            seen = ", ".join(law for law, how in result["laws"].items() if how)
            out.append(f"{patch.name}: {patch.law}, which it names, does not notice; these do: {seen}")
    return out


def sharpest(config, results):
    """{law: (number of defects that it kills, the least number of killers in its class, that defect)}."""
    out = {law: (0, 0, "") for law in config.law_kind}
    for name in sorted(results):
        for needs in NEEDS:
            killers = killers_of(config, results[name], needs)
            for law in killers:
                kills, least, where = out[law]
                if not where or len(killers) < least:
                    least, where = len(killers), name
                out[law] = (kills + 1, least, where)
    return out


def faults_of_laws(config, results):
    out = []
    for law, (kills, least, _) in sharpest(config, results).items():
        if kills == 0:
            out.append(f"{law} kills no defect")
        elif least > FEW:
            out.append(f"{law} is never among {FEW} killers of its class: {least} at the least")
    return out


def how(result, law):
    return result["laws"][law].replace("broken ", "")


def page(config, patches, results):
    """defects.md: by defect who notices, by law what it notices. Nothing in it depends on the machine."""
    tied = sum(1 for patch in patches if patch.reports or patch.classes)
    lines = [
        "# Planted defects", "",
        f"{len(patches)} small patches to the library, its oracles and its checker, and the laws that notice them. "
        f"{tied} are mechanisms of reported failures or of their classes. `./run defects --write` wrote this page. "
        "It plants each defect in a copy. All laws of the defect's kind see generated cases, "
        f"none of them curated: {CASES_OF_ALL['linear']:,} linear ones and ten times as many near-ties, "
        f"{CASES_OF_ALL['query']:,} for the other queries, {CASES_OF_ALL['rotating']:,} rotating ones. The law that a "
        f"patch names sees {CASES['linear']:,}, {CASES['query']:,} and {CASES['rotating']:,}. The first broken case is in "
        "brackets. `crashed` and `hangs` are what the defect did to the method.", "",
        "A law is listed under what it needs. No defect may survive. Each law must notice some defect that at "
        f"most {FEW} laws of its class notice.", ""]
    faults = faults_of_patches(config, patches, results) + faults_of_laws(config, results)
    if faults:
        lines += ["**Not so:** " + "; ".join(faults) + ".", ""]
    for kind in CASES:
        chosen = [patch for patch in patches if results[patch.name]["kind"] == kind]
        if not chosen:
            continue
        lines += [f"## {kind.capitalize()}: by defect", "",
                  "| defect | what is wrong | known from | metamorphic | proof | oracle |", "|---|---|---|---|---|---|"]
        for patch in chosen:
            result = results[patch.name]
            cells = [", ".join(f"{law} ({how(result, law)})" for law in killers_of(config, result, needs)) or "-"
                     for needs in NEEDS]
            known = ", ".join([*patch.reports, *(f"class {letter}" for letter in patch.classes)]) or "-"
            lines.append(f"| {patch.name} | {patch.defect} | {known} | " + " | ".join(cells) + " |")
        lines += ["", f"## {kind.capitalize()}: by law", "",
                  "| law | class | defects noticed | fewest killers | of the defect |", "|---|---|---|---|---|"]
        for law, (kills, least, where) in sharpest(config, results).items():
            if config.law_kind[law] == kind:
                lines.append(f"| {law} | {config.law_needs[law]} | {kills} | {least} | {where or '-'} |")
        lines.append("")
    return "\n".join(lines)


def matrix(config, patches, results):
    """Law x defect as lines of comma-separated values: the first broken case, nothing where the law holds, a dash
    where it is of another kind."""
    names = [patch.name for patch in patches]
    lines = [",".join(["law", "kind", "class", *names])]
    for law, kind in config.law_kind.items():
        cells = [how(results[name], law) if law in results[name]["laws"] else "-" for name in names]
        lines.append(",".join([law, kind, config.law_needs[law], *cells]))
    return "\n".join(lines) + "\n"
