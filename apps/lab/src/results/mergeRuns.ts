import type { LabCase, LabPlan } from '../plan/LabPlan';
import type { LabRow, LabRun } from './LabRun';

/** Key of a case, equal for cases that draw the same picture. */
export function caseKey(labCase: LabCase): string {
  const { scene, lights, shadows, lightKind, lightRange, shading, overdraw, width, height } = labCase;
  const parameters = Object.entries(scene.parameters).sort(([a], [b]) => (a < b ? -1 : 1));
  const matter = [lightKind, lightRange, shading];
  return JSON.stringify([scene.name, parameters, lights, shadows, matter, overdraw, width, height]);
}

/** Matches the problem of a row that was not measured because the run was cancelled or its time was up. */
const unfinished = /^(Cancelled|Not measured)/;

/**
 * Plan of the cases left to measure: those in which a competitor has no row or an unfinished one, and the last case of
 * a run that ended early. Each case is planned with all competitors, since they are measured in turns.
 */
export function remainingPlan({ plan, rows, complete }: Pick<LabRun, 'plan' | 'rows' | 'complete'>): LabPlan {
  const finished = new Set(
    rows
      .filter(({ problem }) => !unfinished.test(problem ?? ''))
      .map((row) => placeOf(row.series, row.index, row.competitor)),
  );
  const begun = new Set(rows.map(({ series, index }) => `${series} ${index}`));
  const last = plan.series
    .flatMap(({ name, cases }) => cases.map((_, index) => `${name} ${index}`))
    .findLast((each) => begun.has(each));
  const series = plan.series.map((each) => {
    const isOpen = each.cases.map(
      (_, index) =>
        (!complete && last === `${each.name} ${index}`) ||
        plan.competitors.some((competitor) => !finished.has(placeOf(each.name, index, competitor))),
    );
    return {
      ...each,
      cases: each.cases.filter((_, index) => isOpen[index]),
      values: each.values.filter((_, index) => isOpen[index]),
    };
  });
  return { ...plan, series: series.filter(({ cases }) => cases.length > 0) };
}

const placeOf = (series: string, index: number, competitor: string): string => `${series} ${index} ${competitor}`;

/**
 * Merges parts of one run: rows of later parts replace those of earlier ones. Cases are matched by series and picture,
 * whatever their index in the part.
 *
 * @param plan - plan of the whole run
 * @param parts - at least one, all measured on one device
 * @throws Error that names the difference if they are not parts of one run
 */
export function mergeRuns(plan: LabPlan, parts: readonly LabRun[]): LabRun {
  const last = parts.at(-1);
  if (!last) throw new Error('There is nothing to merge: give at least one run.');
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
          `The parts are of different plans: ${row.competitor} in case ${row.index} of ${row.series} is not in the plan. Measure all again.`,
        );
      }
      rows.set(placeOf(row.series, index, row.competitor), { ...row, index });
    }
  }
  const ordered = plan.series.flatMap(({ name, cases }) =>
    cases.flatMap((_, index) => plan.competitors.flatMap((each) => rows.get(placeOf(name, index, each)) ?? [])),
  );
  const warnings = [...new Set(parts.flatMap(({ surroundings }) => surroundings.warnings))];
  return {
    ...last,
    id: parts[0].id,
    name: parts.findLast(({ name }) => name !== '')?.name ?? '',
    surroundings: { ...last.surroundings, date: parts[0].surroundings.date, warnings },
    plan,
    rows: ordered,
    complete: last.complete && remainingPlan({ plan, rows: ordered, complete: true }).series.length === 0,
    duration: parts.reduce((sum, { duration }) => sum + duration, 0),
  };
}
