import { psnr } from '../measure/likeness';
import { spreadOf } from '../measure/spread';
import { isNamed, type LabCase, type LabPlan, type LabSeries } from '../plan/LabPlan';
import type { LabRow } from '../results/LabRun';
import type { Stage, Turn } from '../stage/Stage';
import type { Forecast } from './Forecast';
import { spoiled } from './spoiled';
import type { StageFrames } from './StageFrames';
import { messageOf } from './messageOf';

/** Competitors that may draw the reference picture of a case, in order of preference. */
const references = ['stock', 'forward', 'multipass'];

/** A competitor gets no more turns in a case after one that took this many times its planned length. */
const OVERLONG = 8;

export interface CaseWorld {
  readonly plan: LabPlan;
  readonly series: LabSeries;
  readonly labCase: LabCase;
  readonly index: number;
  readonly frames: Pick<StageFrames, 'stageOf'>;
  /** Rows of the run; the case appends its own. */
  readonly rows: LabRow[];
  readonly forecast: Forecast;
  /** Length of a turn, in which one competitor is measured (ms). */
  readonly turn: number;
  readonly signal: AbortSignal;
  readonly now: () => number;
  /** Whether the run's time is up: no further competitor is opened, and no further turn begins. */
  isLate(): boolean;
  step(competitor: string | null, picture?: ImageData): void;
  /** A picture as a data URL. */
  thumbnailOf(picture: ImageData): string;
}

/** An open competitor and its samples (ms) by turn. */
interface Open {
  readonly name: string;
  readonly stage: Stage;
  readonly row: LabRow;
  readonly frame: number[][];
  readonly cpu: number[][];
  readonly gpu: number[][];
  /** Whether the competitor gets no more turns. */
  over: boolean;
}

/** Measures one case: opens every competitor, measures them in turns, compares their pictures, and closes them. */
export class CaseRun {
  private readonly pictures = new Map<string, ImageData>();
  private readonly caseRows: LabRow[] = [];

  constructor(private readonly world: CaseWorld) {}

  /** Measures some competitors in turns, and closes them. */
  async measure(competitors: readonly string[]): Promise<void> {
    const { plan, signal, turn } = this.world;
    const open: Open[] = [];
    try {
      for (const name of competitors) {
        if (signal.aborted) return;
        if (this.world.isLate()) {
          this.addRow(name).problem = this.late();
          continue;
        }
        const opened = await this.open(name);
        if (opened) open.push(opened);
      }
      for (let round = 0; round < plan.effort.rounds; round++) {
        for (const each of open) {
          if (signal.aborted) break;
          this.world.step(each.name);
          // even the shortest run measures one turn of its first case
          const isFirst = round === 0 && this.caseRows.length === this.world.rows.length;
          if (!isFirst && this.world.isLate()) this.endEarly(each);
          if (!each.over) await attempt(each, () => this.takeTurn(each, turn));
        }
      }
      for (const each of open) {
        if (signal.aborted) break;
        this.world.step(each.name);
        if (each.row.problem === null && !this.world.isLate()) await attempt(each, () => this.takeRest(each));
      }
    } finally {
      for (const { stage, name, row } of open) {
        stage.close(name);
        if (!row.frame) row.problem ??= 'Cancelled before it was measured.';
      }
    }
  }

  /** Adds a row for each competitor with the problem that the run's time is up. */
  leaveOut(): void {
    for (const name of this.world.plan.competitors) this.addRow(name).problem = this.late();
  }

  /** Compares the pictures after all competitors were measured. */
  async end(): Promise<void> {
    if (this.pictures.size === 0) return;
    const reference = references.find((name) => this.pictures.has(name)) ?? (await this.drawReference());
    const picture = reference === null ? undefined : this.pictures.get(reference);
    if (reference === null || !picture) return;
    for (const row of this.caseRows) {
      const drawn = this.pictures.get(row.competitor);
      if (drawn) row.likeness = { reference, psnr: psnr(drawn, picture), thumbnail: this.world.thumbnailOf(drawn) };
    }
    this.pictures.clear();
  }

  private addRow(name: string): LabRow {
    const { series, index, rows } = this.world;
    const row = emptyRow(name, series.name, index);
    rows.push(row);
    this.caseRows.push(row);
    return row;
  }

  private late(): string {
    return `Not measured: the run’s limit of ${Math.round((this.world.plan.effort.limit ?? 0) / 1000)} s was reached.`;
  }

  /** Ends a competitor's turns because the run's time is up. */
  private endEarly(each: Open): void {
    const { rounds } = this.world.plan.effort;
    if (!each.row.frame) each.row.problem ??= this.late();
    else if (!each.over) each.row.warnings.push(`${each.frame.length} of ${rounds} turns: the run’s time was up.`);
    each.over = true;
  }

  /** Key for forecasts: the series if its axis has numbers, as times grow with them; the case alone if it has names. */
  private get line(): string {
    const { series, index } = this.world;
    return isNamed(series.axis) ? `${series.name} ${index}` : series.name;
  }

  private async open(name: string): Promise<Open | null> {
    const { series, labCase, index, frames, forecast, signal, plan } = this.world;
    const row = this.addRow(name);
    this.world.step(name);
    try {
      const value = series.values[index];
      row.problem = forecast.refuses(this.line, name, value);
      if (row.problem !== null) return null;
      const stage = await frames.stageOf(name);
      row.problem = await stage.unavailable(name);
      if (row.problem !== null) return null;
      const { longestFrame } = plan.effort;
      const { firstMs, dropped, technique, reason, picture } = await stage.open(name, labCase, {
        signal,
        longestFrame,
      });
      forecast.note(this.line, name, 'first', value, firstMs);
      Object.assign(row, { firstMs, dropped, technique, reason });
      if (dropped > 0) row.warnings.push(`${dropped} lights are left out of its picture.`);
      this.pictures.set(name, picture);
      this.world.step(name, picture);
      return { name, stage, row, frame: [], cpu: [], gpu: [], over: false };
    } catch (error) {
      row.problem = signal.aborted ? 'Cancelled.' : messageOf(error);
      return null;
    }
  }

  private async takeTurn(each: Open, length: number): Promise<void> {
    const { series, index, forecast, now } = this.world;
    const { row, stage, name } = each;
    const begin = now();
    const samples = await visibleTurn(stage, name, length, row.warnings);
    each.frame.push(samples.frame);
    each.cpu.push(samples.cpu);
    if (samples.gpu) each.gpu.push(samples.gpu);
    row.frame = spreadOf(each.frame);
    row.cpu = spreadOf(each.cpu);
    row.gpu = spreadOf(each.gpu);
    const last = each.frame.length === this.world.plan.effort.rounds;
    if (now() - begin > Math.max(OVERLONG * length, 1000) && !last) {
      each.over = true;
      row.warnings.push(
        `Measured in ${each.frame.length} of ${this.world.plan.effort.rounds} turns alone: its frames are long.`,
      );
    }
    if ((last || each.over) && row.frame) {
      forecast.note(this.line, name, 'frame', series.values[index], row.frame.median);
      row.warnings.push(...spoiled(each));
    }
  }

  /** Measures counts and passes of a frame, then frames after changes of the scene. */
  private async takeRest({ row, stage, name }: Open): Promise<void> {
    row.counts = await stage.count(name);
    row.passes = await stage.passes(name);
    const { index, plan } = this.world;
    const { changes, limit } = plan.effort;
    if (!changes || (limit !== null && index > 0) || this.world.isLate()) return;
    const { lights, lightKind } = this.world.labCase;
    // no lights are added to particles, since a changed number restarts all particles
    if (lights !== null && lightKind !== 'particles') row.added = await stage.addLights(name);
    row.changed = await stage.changeTechnique(name);
  }

  /** Draws the reference picture with a competitor that is not in the plan. @returns its key; null when none can */
  private async drawReference(): Promise<string | null> {
    const { frames, labCase, signal, plan } = this.world;
    for (const name of references) {
      if (signal.aborted || plan.competitors.includes(name)) continue;
      try {
        const stage = await frames.stageOf(name);
        if ((await stage.unavailable(name)) !== null) continue;
        const { picture } = await stage.open(name, labCase, { signal, longestFrame: plan.effort.longestFrame });
        this.pictures.set(name, picture);
        stage.close(name);
        return name;
      } catch {
        // this competitor cannot draw the case: the next candidate is tried
      }
    }
    return null;
  }
}

/** Measures a turn in a visible tab, since hidden ones are throttled; repeats it once if it was hidden meanwhile. */
async function visibleTurn(stage: Stage, name: string, length: number, warnings: string[]): Promise<Turn> {
  for (let tried = 0; ; tried++) {
    await visible();
    let hidden = false;
    const onChange = (): void => void (hidden ||= document.hidden);
    globalThis.document?.addEventListener('visibilitychange', onChange);
    const samples = await stage.turn(name, length);
    globalThis.document?.removeEventListener('visibilitychange', onChange);
    if (!hidden) return samples;
    if (tried > 0) {
      warnings.push('The tab was hidden while this was measured: keep it in front.');
      return samples;
    }
  }
}

/** Waits until the tab is visible. */
function visible(): Promise<void> {
  if (!globalThis.document?.hidden) return Promise.resolve();
  return new Promise((resolve) => {
    const onChange = (): void => {
      if (document.hidden) return;
      document.removeEventListener('visibilitychange', onChange);
      resolve();
    };
    document.addEventListener('visibilitychange', onChange);
  });
}

/** Runs work for a competitor; an error becomes the row's problem, or a warning if the row has times already. */
async function attempt(open: Open, work: () => Promise<void>): Promise<void> {
  try {
    await work();
  } catch (error) {
    open.over = true;
    if (open.row.frame) open.row.warnings.push(messageOf(error));
    else open.row.problem = messageOf(error);
  }
}

function emptyRow(competitor: string, series: string, index: number): LabRow {
  return {
    ...{ competitor, series, index, frame: null, cpu: null, gpu: null, firstMs: null, added: null, changed: null },
    ...{ counts: null, passes: null, likeness: null, dropped: 0, technique: null, reason: null, problem: null },
    warnings: [],
  };
}
