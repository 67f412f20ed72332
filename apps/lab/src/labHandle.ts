import { chartFiles } from './charts/chartFiles';
import { competitorNames, type CompetitorWords } from './competitors/competitorNames';
import type { Configuration } from './plan/Configuration';
import type { LabPlan } from './plan/LabPlan';
import { planOf } from './plan/planOf';
import { quickFor } from './plan/presets';
import type { LabRow, LabRun, LabSurroundings } from './results/LabRun';
import { configurationOf } from './results/link';
import { mergeRuns, remainingPlan } from './results/mergeRuns';
import { parseRun } from './results/parseRun';
import { runMarkdown } from './results/runMarkdown';
import { surroundingsOf } from './results/surroundings';
import { type Crash, framesOfBuilds } from './run/framesOfBuilds';
import type { Progress } from './run/Progress';
import { runPlan } from './run/runPlan';

/** Options of a run started from outside of the page. */
export interface HandleOptions {
  /** Command line that started the run, saved in `surroundings` of its JSON. */
  readonly command?: string | null;
  /** Versions in addition to those that the page knows, such as that of the build under `against/`. */
  readonly versions?: Readonly<Record<string, string>>;
  /** Competitors and cases with which the browser crashed: they are not opened again. */
  readonly crashes?: readonly Crash[];
  /** Called before each step of the run, see `Progress`. */
  onStep?(step: Step): unknown;
  /** Called after each case with all rows so far. */
  onCase?(run: LabRun): unknown;
}

/** State of a run before a step, see `Progress`; times in ms. */
export type Step = Pick<Progress, 'done' | 'total' | 'remaining' | 'competitor' | 'labCase'>;

/** A file made of a run, as text. */
export interface TextFile {
  readonly name: string;
  readonly text: string;
}

/** Interface of the page under `?headless`, its `window.lab`: the Lab without a user interface, for `npm run bench`. */
export interface LabHandle {
  readonly competitors: Readonly<Record<string, CompetitorWords>>;
  /** Parses an address's fragment. @throws Error that names all its errors */
  configurationOf(fragment: string): Configuration;
  /** Configuration of the page's quick run. */
  quickFor(device: { software: boolean }): Configuration;
  /** Makes the plan of a configuration. @throws Error naming the value that is out of bounds */
  planOf(configuration: Configuration): LabPlan;
  /**
   * Measures a plan. Competitors with `@against` at the end of their key are drawn by the build under `against/`.
   *
   * @throws Error (as a rejection) during another run, or if the iframe with `stage.html` does not load
   */
  run(plan: LabPlan, options?: HandleOptions): Promise<LabRun>;
  /** Surroundings of a run that would begin now. */
  surroundings(): Promise<LabSurroundings>;
  /** Cancels the run, whose promise then resolves with the rows so far. */
  cancel(): void;
  /** Plan of the cases that a cancelled run, or one whose time was up, has not measured. */
  remaining(run: LabRun): LabPlan;
  /** Merges parts of one run; rows of later parts replace those of earlier ones. @throws Error if they do not match */
  merge(plan: LabPlan, parts: readonly LabRun[]): LabRun;
  /** Parses the JSON of a run. @throws FormatError naming an invalid field */
  parse(json: string): LabRun;
  /** The run as Markdown, and each chart as SVG. */
  files(run: LabRun): TextFile[];
}

declare global {
  interface Window {
    lab?: LabHandle;
  }
}

let running: AbortController | null = null;

async function run(plan: LabPlan, options: HandleOptions = {}): Promise<LabRun> {
  if (running) throw new Error('A run is in progress: wait for it, or call lab.cancel().');
  const controller = new AbortController();
  running = controller;
  const frames = framesOfBuilds(document.body, options.crashes);
  try {
    const device = await (await frames.stageOf('forward')).device();
    const known = await surroundingsOf(device, plan.competitors);
    const surroundings = {
      ...known,
      versions: { ...known.versions, ...options.versions },
      command: options.command ?? null,
    };
    const begin = performance.now();
    let labCase: unknown = null;
    const report = (rows: readonly LabRow[]): void => {
      const duration = performance.now() - begin;
      const id = `${surroundings.date}-part`;
      const format = { format: 'farol-lab-run', version: 1, id, name: '' } as const;
      void options.onCase?.({ ...format, surroundings, plan, rows: [...rows], complete: false, duration });
    };
    return await runPlan(plan, {
      frames,
      surroundings,
      signal: controller.signal,
      onProgress(progress) {
        const { done, total, remaining, competitor, rows } = progress;
        if (labCase !== null && labCase !== progress.labCase)
          report(rows.filter((row) => caseOf(plan, row) !== progress.labCase));
        labCase = progress.labCase;
        void options.onStep?.({ done, total, remaining, competitor, labCase: progress.labCase });
      },
    });
  } finally {
    frames.close();
    running = null;
  }
}

async function surroundings(): Promise<LabSurroundings> {
  const frames = framesOfBuilds(document.body);
  try {
    return await surroundingsOf(await (await frames.stageOf('forward')).device());
  } finally {
    frames.close();
  }
}

const caseOf = (plan: LabPlan, { series, index }: LabRow): unknown =>
  plan.series.find(({ name }) => name === series)?.cases[index];

function configurationIn(fragment: string): Configuration {
  const linked = configurationOf(fragment);
  if (!linked) throw new Error('The address has no configuration: give a preset, as in #preset=quick.');
  if (linked.problems.length > 0) throw new Error(linked.problems.join('\n'));
  return linked.configuration;
}

function files(run: LabRun): TextFile[] {
  const charts = chartFiles(run);
  return [
    { name: 'bench.md', text: runMarkdown(run) },
    ...charts.map(({ name, svg }) => ({ name: `${name}.svg`, text: svg })),
  ];
}

/** Sets `window.lab`. */
export function installLabHandle(): void {
  window.lab = {
    competitors: competitorNames,
    configurationOf: configurationIn,
    quickFor,
    planOf,
    run,
    surroundings,
    cancel: () => running?.abort(),
    remaining: remainingPlan,
    merge: mergeRuns,
    parse: parseRun,
    files,
  };
}
