import { Signal, t } from '@farol/editing';
import { followEffects } from '@farol/engine';
import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import { type Camera, HalfFloatType, type Scene, Vector2, WebGLRenderTarget } from 'three';
import type { MicroShaderEditing } from '../../microshaders/MicroShaderEditing';
import { drawsFloats } from '../drawsFloats';
import type { Painter } from '../Painter';
import type { Viewport } from '../Viewport';
import { whenLost } from '../whenLost';
import { type DifferenceFigures, PictureDifference } from './PictureDifference';

/** Interval between two measurements (ms). */
const MEASURE_EVERY = 500;

const size = new Vector2();

/** Compares the technique in use with another one: side by side with a movable border, or as their difference. */
export class WipePainter implements Painter {
  readonly isGrid = false;
  /** Emits when a setting or the measurements change. */
  readonly changed = new Signal();
  /** Renders the other technique, with statistics of its own. */
  readonly other: FarolRenderer;

  private readonly difference: PictureDifference;
  private readonly targets = [0, 1].map(() => new WebGLRenderTarget(1, 1, { type: HalfFloatType }));
  private readonly endMicroShaders: () => void;
  private readonly endLost: () => void;
  private where = 0.5;
  private isDifference = false;
  private factor = 8;
  private last: DifferenceFigures | null = null;
  private measuredAt = -Infinity;
  private isMeasuring = false;
  private isDisposed = false;

  /**
   * @param technique - the technique to compare with
   * @throws Error naming the missing feature of the device
   */
  constructor(
    private readonly viewport: Viewport,
    microShaders: MicroShaderEditing,
    technique: TechniqueName,
  ) {
    if (!drawsFloats(viewport.webgl, true)) {
      throw new Error(
        t('Techniques cannot be compared: this device cannot draw to float colour buffers (EXT_color_buffer_float).'),
      );
    }
    this.other = new FarolRenderer(viewport.webgl, { timing: true });
    for (const [name, each] of Object.entries(viewport.farol.techniques)) {
      if (!Object.hasOwn(this.other.techniques, name)) this.other.addTechnique(name, each);
    }
    this.other.technique = technique;
    this.endMicroShaders = microShaders.addRegistry(this.other.microshaders);
    this.difference = new PictureDifference(viewport.webgl);
    this.endLost = whenLost(viewport.webgl, () => this.targets.forEach((target) => target.dispose()));
  }

  get drawsHelpers(): boolean {
    return !this.isDifference;
  }

  get technique(): TechniqueName {
    return this.other.technique;
  }

  /** Technique to compare with. @throws Error naming the missing feature of the device */
  set technique(technique: TechniqueName) {
    this.other.technique = technique;
    this.settingChanged();
  }

  /** Position of the border, from 0 (left edge) to 1. */
  get at(): number {
    return this.where;
  }

  set at(at: number) {
    this.where = Math.min(1, Math.max(0, at));
    this.settingChanged();
  }

  /** Whether the difference is shown instead of both images. */
  get showsDifference(): boolean {
    return this.isDifference;
  }

  set showsDifference(shows: boolean) {
    this.isDifference = shows;
    this.settingChanged();
  }

  /** Factor by which the displayed difference of the images is multiplied. */
  get gain(): number {
    return this.factor;
  }

  set gain(gain: number) {
    this.factor = gain;
    this.settingChanged();
  }

  /** Measured difference of the images; null until measured. */
  get figures(): DifferenceFigures | null {
    return this.last;
  }

  render(scene: Scene, camera: Camera): void {
    const { viewport, other } = this;
    other.view = viewport.view;
    other.heatMapMaximum = viewport.farol.heatMapMaximum;
    followEffects(other, viewport.document.scene);
    const isDue = !this.isMeasuring && performance.now() - this.measuredAt > MEASURE_EVERY;
    if (isDue || this.isDifference) this.drawTargets(scene, camera);
    if (isDue) void this.measure();
    if (this.isDifference) this.difference.show(this.targets[0].texture, this.targets[1].texture, this.factor);
    else this.drawWipe(scene, camera);
  }

  dispose(): void {
    this.isDisposed = true;
    this.endMicroShaders();
    this.endLost();
    this.other.dispose();
    this.difference.dispose();
    for (const target of this.targets) target.dispose();
  }

  private settingChanged(): void {
    this.measuredAt = -Infinity;
    this.changed.emit();
    this.viewport.invalidate();
  }

  private drawWipe(scene: Scene, camera: Camera): void {
    const { webgl, farol } = this.viewport;
    const { width, height } = this.viewport.size;
    const left = Math.round(this.where * width);
    webgl.setScissorTest(true);
    if (left < width) {
      webgl.setScissor(left, 0, width - left, height);
      this.other.render(scene, camera);
    }
    if (left > 0) {
      webgl.setScissor(0, 0, left, height);
      farol.render(scene, camera);
    }
    webgl.setScissor(0, 0, width, height);
    webgl.setScissorTest(false);
  }

  private drawTargets(scene: Scene, camera: Camera): void {
    const { webgl, farol } = this.viewport;
    webgl.getDrawingBufferSize(size);
    const previousTarget = webgl.getRenderTarget();
    [farol, this.other].forEach((renderer, i) => {
      this.targets[i].setSize(size.x, size.y);
      webgl.setRenderTarget(this.targets[i]);
      renderer.render(scene, camera);
    });
    webgl.setRenderTarget(previousTarget);
  }

  private async measure(): Promise<void> {
    this.isMeasuring = true;
    this.measuredAt = performance.now();
    const [a, b] = this.targets;
    try {
      const figures = await this.difference.measure(a.texture, b.texture, size.x, size.y);
      if (this.isDisposed || !figures) return;
      this.last = figures;
      this.changed.emit();
    } finally {
      this.isMeasuring = false;
    }
  }
}
