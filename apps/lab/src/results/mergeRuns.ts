import type { LabCase, LabPlan } from '../plan/LabPlan';
import type { LabRow, LabRun } from './LabRun';

/** The same for cases that draw the same picture. */
export function caseKey({ scene, lights, shadows, overdraw, width, height }: LabCase): string {
  const parameters = Object.entries(scene.parameters).sort(([a], [b]) => (a < b ? -1 : 1));
  return JSON.stringify([scene.name, parameters, lights, shadows, overdraw, width, height]);
}

/** The cases of which a competitor has no row yet, each with all competitors, so that they are measured in turns. */
export function remainingPlan(plan: LabPlan, rows: readonly LabRow[]): LabPlan {
  const there = new Set(rows.map(({ competitor, series, index }) => `${competitor} ${series} ${index}`));
  const series = plan.series.map((each) => {
    const open = each.cases.map((_, index) =>
      plan.competitors.some((name) => !there.has(`${name} ${each.name} ${index}`)),
    );
    return {
      ...each,
      cases: each.cases.filter((_, index) => open[index]),
      values: each.values.filter((_, index) => open[index]),
    };
  });
  return { ...plan, series: series.filter(({ cases }) => cases.length > 0) };
}

/**
 * Parts of one run as one: rows of later parts stand in place of those of earlier ones. Cases are found by series and
 * what they draw, wherever they stand in their part.
 *
 * @param plan of the whole run
 * @param parts at least one, of one device
 * @throws Error that names what the parts differ in, where they are no parts of one run
 */
export function mergeRuns(plan: LabPlan, parts: readonly LabRun[]): LabRun {
  const last = parts.at(-1);
  if (!last) throw new Error('No parts: give a run at least.');
  const places = new Map(
    plan.series.flatMap(({ name, cases }) => cases.map((each, index) => [`${name} ${caseKey(each)}`, index])),
  );
  const rows = new Map<string, LabRow>();
  for (const part of parts) {
    for (const field of ['device', 'browser', 'build'] as const) {
      const [ours, theirs] = [last.surroundings[field], part.surroundings[field]];
      if (ours !== theirs) {
        throw new Error(`The parts are of different runs: ${field} is "${theirs}" and "${ours}". Measure all anew.`);
      }
    }
    for (const row of part.rows) {
      const labCase = part.plan.series.find(({ name }) => name === row.series)?.cases[row.index];
      const index = labCase && places.get(`${row.series} ${caseKey(labCase)}`);
      if (index === undefined || !plan.competitors.includes(row.competitor)) {
        throw new Error(
          `The parts are of different plans: ${row.competitor} in case ${row.index} of ${row.series} is not asked for.`,
        );
      }
      rows.set(`${row.series} ${index} ${row.competitor}`, { ...row, index });
    }
  }
  const ordered = plan.series.flatMap(({ name, cases }) =>
    cases.flatMap((_, index) => plan.competitors.flatMap((each) => rows.get(`${name} ${index} ${each}`) ?? [])),
  );
  const warnings = [...new Set(parts.flatMap(({ surroundings }) => surroundings.warnings))];
  return {
    ...last,
    id: parts[0].id,
    name: parts.findLast(({ name }) => name !== '')?.name ?? '',
    surroundings: { ...last.surroundings, date: parts[0].surroundings.date, warnings },
    plan,
    rows: ordered,
    complete: remainingPlan(plan, ordered).series.length === 0,
    duration: parts.reduce((sum, { duration }) => sum + duration, 0),
  };
}
