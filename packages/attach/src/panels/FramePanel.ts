import { t } from '@farol/editing';
import type { View } from '@farol/renderer';
import type { Drawer, Drawing } from '../model/Drawing';
import type { Session } from '../model/Session';
import { element } from '../ui/element';
import type { RenderHook } from '../viewport/RenderHook';

/** Panel that selects renderer and view, and shows counts of a frame; with Farol also counts and times of passes. */
export class FramePanel {
  readonly element: HTMLElement;
  private readonly load = element('button', { type: 'button' }, t('Draw with Farol'));
  private readonly technique = element('select', { id: 'technique' });
  private readonly view = element('select', { id: 'view' });
  private readonly timing = element('input', { id: 'timing', type: 'checkbox' });
  private readonly menus: HTMLElement;
  private readonly figures = element('p', { className: 'figures' });
  private readonly lacking = element('p', { role: 'status' });
  private readonly rows = element('tbody');
  private readonly table: HTMLElement;
  private readonly problem = element('p', { role: 'alert' });
  private readonly end: () => void;
  private counted = { frames: 0, at: performance.now() };

  constructor(
    private readonly session: Session,
    private readonly hook: RenderHook,
    private readonly drawing: Drawing,
  ) {
    const row = (id: string, label: string, control: HTMLElement) =>
      element('div', { className: 'field' }, element('label', { htmlFor: id, className: 'label' }, label), control);
    this.menus = element(
      'div',
      { hidden: true },
      row('technique', t('Technique'), this.technique),
      row('view', t('View'), this.view),
      row('timing', t('GPU times'), this.timing),
    );
    const heads = [t('Pass'), t('Draws'), 'CPU ms', 'GPU ms'].map((text) => element('th', { scope: 'col' }, text));
    this.table = element('table', { hidden: true }, element('thead', {}, element('tr', {}, ...heads)), this.rows);
    this.element = element(
      'details',
      { open: true, className: 'frame' },
      ...[
        element('summary', {}, t('Frame')),
        this.load,
        this.menus,
        this.problem,
        this.lacking,
        this.figures,
        this.table,
      ],
    );
    this.load.addEventListener('click', () => void this.choose('auto'));
    this.technique.addEventListener('change', () => void this.choose(this.technique.value as Drawer));
    this.view.addEventListener('change', () => {
      void this.tell(() => {
        if (drawing.farol) drawing.farol.view = this.view.value as View;
      });
      session.edited.emit();
    });
    this.timing.addEventListener('change', () => {
      if (drawing.farol) drawing.farol.timing = this.timing.checked;
    });
    this.end = drawing.changed.subscribe(() => this.show());
    this.show();
  }

  /** Updates the shown figures. Call a few times a second. */
  refresh(): void {
    const { webgl } = this.session;
    const { farol } = this.drawing;
    const now = performance.now();
    const rate = ((this.hook.frames - this.counted.frames) * 1000) / Math.max(1, now - this.counted.at);
    this.counted = { frames: this.hook.frames, at: now };
    const { calls, triangles } = farol?.info ? { calls: farol.info.drawCalls, ...farol.info } : webgl.info.render;
    const figures = { rate: rate.toFixed(0), calls, triangles: triangles.toLocaleString('en') };
    const text = farol
      ? t('{rate} frames/s, {calls} draws, {triangles} triangles, {visible} of {total} lights', {
          ...figures,
          visible: farol.info.lights.visible,
          total: farol.info.lights.total,
        })
      : t('{rate} frames/s, {calls} draws, {triangles} triangles', figures);
    if (this.figures.textContent !== text) this.figures.textContent = text;
    const lacking = t(farol?.info.view?.problem ?? '');
    if (this.lacking.textContent !== lacking) this.lacking.textContent = lacking;
    if (!farol) return;
    const milliseconds = (value: number | null) => (value === null ? '–' : value.toFixed(2));
    const cells = farol.info.passes.map(({ name, drawCalls, cpuMs, gpuMs }) => [
      ...[name, String(drawCalls), milliseconds(cpuMs), milliseconds(gpuMs)],
    ]);
    this.rows.replaceChildren(...cells.map((row) => element('tr', {}, ...row.map((cell) => element('td', {}, cell)))));
  }

  dispose(): void {
    this.end();
  }

  private async choose(drawer: Drawer): Promise<void> {
    await this.tell(() => this.drawing.choose(drawer));
  }

  /** Changes the renderer; if that fails, shows the error and the renderer that stays. */
  private async tell(change: () => void | Promise<void>): Promise<void> {
    this.problem.textContent = '';
    try {
      await change();
    } catch (error) {
      this.problem.textContent = error instanceof Error ? error.message : String(error);
      this.show();
    }
  }

  private show(): void {
    const { module, given, drawer, farol } = this.drawing;
    this.load.hidden = module !== null;
    this.menus.hidden = module === null;
    this.table.hidden = farol === null;
    this.view.disabled = this.timing.disabled = farol === null;
    if (!module) return;
    if (this.technique.length === 0) {
      if (!given) this.technique.append(new Option(t("three's own renderer"), 'three'));
      for (const [name, { label }] of Object.entries(module.techniques))
        this.technique.append(new Option(t(label), name));
      this.view.append(...module.views.map((name) => new Option(name, name)));
    }
    this.technique.value = drawer;
    this.view.value = farol?.view ?? 'final';
    this.timing.checked = farol?.timing ?? false;
  }
}
