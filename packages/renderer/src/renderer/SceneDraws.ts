import { DoubleSide, type Vector4 } from 'three';
import { type ActiveEffects, NO_EFFECTS } from '../frame/ActiveEffects';
import { drawPasses } from './drawPasses';
import type { Frame } from '../frame/Frame';
import { antialiasingCode, budgetCode } from './lazyCode';
import { targetSizes } from '../gpu/fitTarget';
import type { ScaledFrames } from './budget';
import { type BudgetInfo, checkBudget, type FrameBudget } from './FrameBudget';
import type { InfoRecorder } from './InfoRecorder';
import type { Pass } from '../frame/Pass';
import type { LazyViews } from './LazyViews';
import { isSurfaceView } from '../frame/views';
import { drawEarly } from '../passes/forward/drawEarly';
import { forwardTwins } from '../materials/forwardTwin';
import { plainBack } from '../materials/plainTwins';
import type { SmoothEdges } from '../effects/antialiasing/SmoothEdges';
import type { TechniquePicker } from './TechniquePicker';
import type { TechniqueSet } from './TechniqueSet';
import { clearValue } from '../three/clearValue';
import type { DrawScene, SceneView } from './SceneView';

/** Draws a frame inside three's `render`, where three would draw the objects of the scene. */
export class SceneDraws {
  sceneView!: SceneView;
  effects: ActiveEffects = NO_EFFECTS;
  /** Anti-aliasing of techniques that shade a G-buffer; null until a frame needs it and its code is loaded. */
  edges: SmoothEdges | null = null;
  /** Draws at the scale of a frame budget; null until there is one. */
  scaled: ScaledFrames | null = null;
  private givenBudget: FrameBudget | null = null;
  private checked: Required<FrameBudget> | null = null;
  private antialias = false;
  /**
   * Twins for objects seen through transmissive ones: they loop over all lights, since light lists are for the main picture's
   * size, which is not the transmission target's.
   */
  private readonly transmittedTwins = forwardTwins('lightLoopAll');

  /** @param background - uniform set to the colour that three would have cleared to; alpha is -1 if three has cleared */
  constructor(
    private readonly frame: Frame,
    private readonly recorder: InfoRecorder,
    private readonly views: LazyViews,
    private readonly set: TechniqueSet,
    private readonly picker: TechniquePicker,
    private readonly background: Vector4,
  ) {}

  private readonly enlarge = () => this.scaled!.enlarge(this.frame);
  private readonly drawFields = () => this.frame.fields!.render();

  /** Begins the draws of a frame; `antialias` and `learning` are those of `FarolOptions`. */
  begin(
    sceneView: SceneView,
    effects: ActiveEffects,
    { antialias, learning }: { readonly antialias: boolean; readonly learning: boolean },
  ): void {
    const { picker } = this;
    this.antialias = antialias;
    picker.learns = learning;
    // trials would disturb a frame budget, which times frames itself and changes their size
    picker.mayMeasure = this.checked === null;
    picker.passTimer = this.recorder.passTimer;
    this.sceneView = sceneView;
    sceneView.seenBy = this.frame.seenBy;
    this.frame.queue.order = sceneView.overdraw?.order ?? null;
    this.effects = effects;
    this.frame.adapters = effects.adapters;
    this.frame.gbufferExtras = effects.attachments;
  }

  /** @throws RangeError for a value that a budget cannot have */
  get budget(): FrameBudget | null {
    return this.givenBudget;
  }

  set budget(budget: FrameBudget | null) {
    const checked = budget === null ? null : checkBudget(budget);
    // an equal budget keeps the controller, with the load that it has measured
    if (JSON.stringify(checked) !== JSON.stringify(this.checked)) this.checked = checked;
    this.givenBudget = budget;
    if (budget !== null) budgetCode.ask();
  }

  get bytes(): number {
    return (this.edges?.bytes ?? 0) + (this.scaled?.bytes ?? 0);
  }

  /** Ends a frame, also one that has failed. */
  end(): void {
    this.scaled?.end(this.frame);
    this.picker.learning?.end();
  }

  dispose(): void {
    this.picker.learning?.dispose();
    this.edges?.dispose();
    this.scaled?.dispose();
  }

  /** Scales the frame to hold the budget. @returns the scale and its reason; null without a budget, or until its code is loaded */
  scale(): BudgetInfo | null {
    targetSizes.room = 0;
    // not in XR: the scale of the headset's picture is set by XRWebGLLayer
    if (this.checked === null || this.frame.session !== null) return null;
    this.scaled ??= budgetCode.use((code) => new code.ScaledFrames(this.frame));
    this.scaled?.begin(this.frame, this.checked, this.recorder.passTimer);
    return this.scaled?.info ?? null;
  }

  /** Draws the scene. SceneView calls it for three's transmission target if an object transmits, then for the host's target. */
  readonly draw: DrawScene = (backs) => {
    for (const effect of this.effects.all) {
      if (effect.compute === undefined) continue;
      this.recorder.beginPass(effect.name);
      effect.compute(this.frame);
      this.recorder.endPass();
    }
    if (this.frame.fields?.isDrawn === false) this.run('light fields', this.drawFields);
    if (backs) this.drawTransmittedBacks();
    else if (this.frame.webgl.getRenderTarget() !== this.frame.target) this.drawTransmitted();
    else {
      this.drawFrame();
      if (this.frame.ownsPart) this.run('enlargement', this.enlarge);
    }
  };

  /** Effects of the frame, with SMAA if `antialias` asks for it and the technique does not smooth edges. */
  effectsOf(technique: string): ActiveEffects {
    const { effects, frame } = this;
    if (!this.antialias || frame.view !== 'final' || frame.hostSamples === 0) return effects;
    if (!this.set.passesOf(technique).some(shadesGBuffer)) return effects;
    this.edges ??= antialiasingCode.use((code) => new code.SmoothEdges());
    return this.edges?.addTo(effects, frame) ?? effects;
  }

  /** Runs draws as a pass of that name in `FarolInfo.passes`. */
  run(name: string, render: () => void): void {
    this.recorder.beginPass(name);
    render();
    this.recorder.endPass();
  }

  private drawFrame(): void {
    const { frame, picker, set, effects } = this;
    this.sceneView.dropTransmissive();
    this.recorder.info.view = null;
    this.setBackground();
    if (isSurfaceView(frame.view)) {
      this.showSurface();
      frame.bindTarget();
      return;
    }
    const overdraw = frame.view === 'overdraw' ? this.views.passes!.overdraw : null;
    if (overdraw !== null) this.run('overdraw', () => overdraw.render(frame, set.drawsDepthFirst(picker.active)));
    drawEarly(frame, this.transmittedTwins('final'));
    drawPasses(frame, picker.active, set.passesOf(picker.active), effects.all, this.recorder);
    if (overdraw !== null && !set.showsOverdraw(picker.active)) overdraw.show(frame);
    if (frame.view === 'grid') this.showSurface();
    picker.warmUp(this.sceneView, frame, this);
    const { buffer, passes: shown } = this.views;
    if (buffer !== null && frame.session === null)
      this.run('view', () => (this.recorder.info.view = shown!.buffers.show(frame, buffer)));
    frame.bindTarget();
  }

  /** Draws the objects behind transmissive ones into three's transmission target. */
  private drawTransmitted(): void {
    const { queue } = this.frame;
    for (const item of queue.opaque) this.frame.drawForward(item, this.transmittedTwins('final'));
    // the loop has marked items of node materials as drawn; they must still be drawn into the host's target
    for (const item of queue.opaque) item.drawn = false;
  }

  /** Draws back faces of transmissive objects over three's transmission target, since front faces show them. */
  private drawTransmittedBacks(): void {
    const { frame } = this;
    const { back } = this.transmittedTwins('final');
    let drawn = false;
    for (const item of frame.queue.transmissive) {
      if (item.material.side !== DoubleSide) continue;
      frame.drawTwin(item, item.shading === 'lit' ? back : plainBack);
      drawn = true;
    }
    if (drawn) frame.resolveTransmission();
  }

  /** Sets the colour that three would have cleared to, for techniques that fill the target. */
  private setBackground(): void {
    const { frame, background } = this;
    frame.fills = this.sceneView.uncleared;
    if (frame.fills !== null) clearValue(frame.webgl, frame.scene, frame.premultiplied, background);
    else background.w = -1;
  }

  private showSurface(): void {
    this.run('view', () => this.views.passes!.surfaceView.render(this.frame));
  }
}

/** True for the passes of techniques that shade one sample a pixel. */
const shadesGBuffer = ({ reads }: Pass): boolean => reads.includes('gbuffer');
