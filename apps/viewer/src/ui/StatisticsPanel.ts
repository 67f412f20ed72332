import { formatCount, t } from '@farol/editing';
import { type FarolInfo, techniques } from '@farol/renderer';

/** Names of techniques, in English. */
const labels: Readonly<Record<string, string>> = Object.fromEntries(
  Object.entries(techniques).map(([name, { label }]) => [name, label]),
);

/** Formats numbers with separated thousands. */
const counted = (values: Readonly<Record<string, number>>): Record<string, string> =>
  Object.fromEntries(Object.entries(values).map(([name, value]) => [name, formatCount(value)]));

/** Frame rate, counts and times of passes. Call `frameDrawn` after each frame; the page is updated 4 times a second. */
export class StatisticsPanel {
  readonly element = document.createElement('div');

  private readonly summary = document.createElement('div');
  private readonly rows = document.createElement('tbody');
  private frames = 0;
  private since = performance.now();

  /** @param period - time between two updates of the page (ms) */
  constructor(private readonly period = 250) {
    this.element.className = 'statistics';
    const table = document.createElement('table');
    const head = table.createTHead().insertRow();
    for (const title of [t('Pass'), t('Draws'), 'CPU ms', 'GPU ms']) {
      const cell = document.createElement('th');
      cell.textContent = title;
      head.append(cell);
    }
    table.append(this.rows);
    this.element.append(this.summary, table);
  }

  /** @param now - time of the frame (ms), as of `performance.now()` */
  frameDrawn(info: FarolInfo, now: number): void {
    this.frames++;
    const elapsed = now - this.since;
    if (elapsed < this.period) return;
    this.show(info, (this.frames * 1000) / elapsed);
    this.frames = 0;
    this.since = now;
  }

  /** Updates the displayed counts and times at once. @param fps - frames per second; null for a single frame */
  show(info: FarolInfo, fps: number | null): void {
    this.summary.textContent = [
      fps === null ? t('Stopped') : t('{rate} frames a second', { rate: fps.toFixed(0) }),
      t('{visible} of {total} lights in view', counted(info.lights)),
      t('{draws} draws, {triangles} triangles', counted({ draws: info.drawCalls, triangles: info.triangles })),
      t('{programs} programs, {size} MiB of targets', {
        programs: info.programs,
        size: (info.targetBytes / 2 ** 20).toFixed(1),
      }),
      `${t('Technique')}: ${t(labels[info.technique] ?? info.technique)}`,
      ...(info.reason === 'asked for' ? [] : [`${t('Why')}: ${t(info.reason)}`]),
      ...(info.hint ? [info.hint] : []),
    ].join('\n');
    while (this.rows.rows.length > info.passes.length) this.rows.deleteRow(-1);
    info.passes.forEach((pass, index) => {
      const row = this.rows.rows[index] ?? this.newRow();
      const texts = [pass.name, String(pass.drawCalls), pass.cpuMs.toFixed(2), pass.gpuMs?.toFixed(2) ?? '–'];
      texts.forEach((text, cell) => (row.cells[cell].textContent = text));
    });
  }

  private newRow(): HTMLTableRowElement {
    const row = this.rows.insertRow();
    for (let i = 0; i < 4; i++) row.insertCell();
    return row;
  }
}
