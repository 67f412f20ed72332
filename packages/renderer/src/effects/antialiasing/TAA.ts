import { Camera, Matrix4, type Object3D, type PerspectiveCamera, type Texture, Vector2, Vector4 } from 'three';
import type { Frame } from '../../frame/Frame';
import { targetSizes } from '../../gpu/fitTarget';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import displayTransfer from '../../frame/displayTransfer.glsl?raw';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import type { MotionBuffer } from '../../frame/EffectBuffers';
import type { FarolEffect } from '../../frame/FarolEffect';
import { RecentlyUsed } from '../../frame/RecentlyUsed';
import { Picture } from '../Picture';
import { cellWeights } from './cellWeights';
import { halton } from './halton';
import lanczosCross from './lanczosCross.glsl?raw';
import { looksOf, surroundingsOf } from './looksOf';
import { MotionPass } from './MotionPass';
import { DistancePass } from '../../passes/forward/DistancePass';
import { storedKind } from '../../passes/gbuffer/gbufferUniforms';
import taaDepth from './taaDepth.glsl?raw';
import taaNear from './taaNear.glsl?raw';
import taaPicture from './taaPicture.glsl?raw';
import taaResolve from './taaResolve.glsl?raw';
import { standInOf } from '../../three/standInOf';
import { TemporalHistory } from './TemporalHistory';
import { contextLists } from '../../three/contextLists';

const SIZE = ['farol_frameSize'];
/** Number of sample positions in a pixel that frames cycle through. */
const SAMPLES = 32;
/** Factor on the new frame's weight for still pixels while other pixels move. */
const STILL = 0.5;
/** Number of frames after a change of lights or materials in which history is always clipped to neighbouring colours. */
const RELIT = 8;
/** Number of frames after an object appears or begins to move in which no pixel counts as still. */
const MET = 2;
/** Number of frames without any change after which all frames are averaged. */
const SETTLED = 4;
/** Weight of the accumulated picture, as a number of frames, after objects have moved. */
const MOVED = 3;
/** Number of pixels from which on the default of `cells` is 1. */
const LARGE = 4e6;
/** Cosine of the camera's turn between two frames below which the frame counts as a cut to another shot. */
const CUT = 0.7;

export interface TAAOptions {
  /**
   * History cells along a pixel's side: 2 stays sharp in motion, at 72 bytes a pixel; 1 takes 24. Default 2, or 1 from 4 million
   * pixels on. Always 1 if the device's targets cannot be twice the picture's size.
   */
  readonly cells?: 1 | 2;
}

/**
 * Temporal anti-aliasing. Each frame is drawn with the projection (of a stand-in for the host's camera) shifted within
 * the pixel, and mixed with the history of earlier frames, sampled where the pixel's surface was then: by depth and
 * camera motion, and for moving objects, skins, morphs, instances and batches by a motion pass. The history has four
 * cells a pixel, so that repeated sampling does not blur it. At edges whose depth agrees with the last frame's it is
 * used unchanged; elsewhere it is clipped to the colours of the pixel's neighbours (variance clipping in YCoCg). A
 * picture without changes becomes the mean of 32 samples in each pixel. Works with every technique. Changes are
 * detected from matrices, lights and properties of materials; the host's own shaders and videos count as always
 * changing, and what such shaders move may ghost. Pixels of particles, now or in the last frame, use no history.
 * @see Karis 2014, High Quality Temporal Supersampling, https://advances.realtimerendering.com/s2014/
 * @see Yang et al. 2009, Amortized Supersampling, https://doi.org/10.1145/1618452.1618481
 * @see Salvi 2016, An Excursion in Temporal Supersampling (GDC)
 */
export class TAA implements FarolEffect {
  readonly name = 'TAA';
  readonly lacks = lacksFloatTargets;
  readonly takesPicture = true;
  readonly smoothsEdges = true;
  readonly movesCamera = true;
  /**
   * Weight of a new sample in its quarter of a moving pixel; half of that in the other quarters. Above 0, at most 1.
   * Default 0.65.
   */
  share = 0.65;
  /** Clipping distance of untrusted history, in standard deviations of the pixel's neighbours; above 0. Default 2. */
  gamma = 2;
  private readonly histories: TemporalHistory[] = [];
  private readonly recent = new RecentlyUsed<TemporalHistory>((history) => {
    this.histories.splice(this.histories.indexOf(history), 1);
    history.dispose();
  });
  private history!: TemporalHistory;
  private readonly views = new WeakMap<Camera, Camera>();
  private readonly jitter = { value: new Vector2() };
  private readonly motion = new MotionPass(this.jitter.value);
  private readonly viewProjection = new Matrix4();
  private readonly jitterDepth = {
    farol_pictureDepth: { value: null as Texture | null },
    farol_motionMap: { value: null as Texture | null },
    farol_reproject: { value: new Matrix4() },
    farol_jitter: this.jitter,
    farol_distances: { value: null as Texture | null },
    farol_distanceDepth: { value: null as Texture | null },
    farol_distancesStored: { value: 0 },
    farol_depthKind: { value: new Vector2() },
    farol_projectZ: { value: new Vector4() },
    farol_hasMotion: { value: false },
  };
  private readonly pastCells = { farol_history: { value: null as Texture | null }, farol_cells: { value: 2 } };
  private readonly near = new FullscreenPass({
    program: 'TAA near',
    fragment: 'taaNear',
    shared: SIZE,
    microShaders: { taaDepth, taaNear },
    uniforms: this.jitterDepth,
  });
  private readonly average = new FullscreenPass({
    program: 'TAA picture',
    fragment: 'taaPicture',
    microShaders: { taaPicture },
    uniforms: this.pastCells,
  });
  private readonly resolve = new FullscreenPass({
    program: 'TAA',
    fragment: 'taaResolve',
    shared: SIZE,
    microShaders: { displayTransfer, lanczosCross, taaDepth, taaResolve },
    uniforms: {
      ...this.jitterDepth,
      ...this.pastCells,
      farol_picture: { value: null as Texture | null },
      farol_reach: { value: null as Texture | null },
      farol_reachBefore: { value: null as Texture | null },
      farol_weights: { value: new Vector4() },
      farol_encoded: { value: false },
      farol_hasPast: { value: false },
      farol_sizeBefore: { value: new Vector2() },
      farol_share: { value: new Vector2(1, 1) },
      farol_gamma: { value: 0 },
      farol_belief: { value: 0 },
      farol_reactive: { value: null as Texture | null },
      farol_reactiveBefore: { value: null as Texture | null },
      farol_isReactive: { value: [0, 0] },
    },
  });
  private readonly buffer: { -readonly [Key in keyof MotionBuffer]: MotionBuffer[Key] } = {
    uniforms: { ...this.jitterDepth, farol_hasPast: this.resolve.uniforms.farol_hasPast },
    reactive: null,
  };
  private readonly distances = new DistancePass();
  private shared: Picture | null = null;
  /** True from `begin` to `end`. If true at `begin`, an exception has ended the last frame. */
  private open = false;
  private contextLists: unknown = null;

  /** @throws RangeError for other `cells` than 1 and 2 */
  constructor(private readonly options: TAAOptions = {}) {
    const { cells } = options;
    if (cells !== undefined && cells !== 1 && cells !== 2)
      throw new RangeError(`TAA: cells is ${String(cells)}; give 1 or 2.`);
  }

  get bytes(): number {
    let bytes = this.motion.bytes + this.distances.bytes + (this.shared?.bytes ?? 0);
    for (const history of this.histories) bytes += history.bytes;
    return bytes;
  }

  /** Forgets the history. Call after a cut, or after a change that cannot be detected from the scene's objects. */
  reset(): void {
    for (const history of this.histories) history.reset();
  }

  begin(frame: Frame): void {
    // the targets hold a failed frame, or were lost with the context (three.js then has new render lists)
    if (this.open || this.contextLists !== contextLists(frame.webgl)) this.reset();
    this.open = true;
    this.contextLists = contextLists(frame.webgl);
    this.shared = Picture.of(frame);
    this.shared.begin(frame);
    const { camera, width, height } = frame;
    const history = (this.history = this.historyOf(frame));
    this.viewProjection.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    if (this.isCut(history, camera)) history.reset();
    const sample = (history.count % SAMPLES) + 1;
    this.jitter.value.set(((halton(sample, 2) - 0.5) * 2) / width, ((halton(sample, 3) - 0.5) * 2) / height);
    frame.camera = this.viewOf(camera);
    history.reactive.begin(this.shared.target);
    frame.reactive = history.reactive;
  }

  end(frame: Frame): void {
    const { history, motion, viewProjection, near, average, resolve } = this;
    const { uniforms } = resolve;
    const picture = this.shared!;
    this.drawMotion(frame);
    uniforms.farol_picture.value = picture.texture;
    uniforms.farol_pictureDepth.value = picture.target.depthTexture;
    uniforms.farol_history.value = history.texture;
    uniforms.farol_reachBefore.value = history.reach;
    uniforms.farol_motionMap.value = motion.target?.texture ?? null;
    uniforms.farol_hasMotion.value = motion.drawn;
    const { now, previous } = history.reactive;
    uniforms.farol_reactive.value = now ?? picture.texture;
    uniforms.farol_reactiveBefore.value = previous ?? picture.texture;
    uniforms.farol_isReactive.value[0] = now === null ? 0 : 1;
    uniforms.farol_isReactive.value[1] = previous === null ? 0 : 1;
    uniforms.farol_hasPast.value = !history.isEmpty;
    uniforms.farol_sizeBefore.value.copy(history.sizeBefore);
    uniforms.farol_encoded.value = picture.encoded;
    this.setDepthKind(frame);
    this.drawDistances(frame);
    uniforms.farol_reproject.value.copy(viewProjection).invert().premultiply(history.viewProjection);
    this.setShares(frame);
    const { next, nextReach } = history;
    near.drawTo(frame, nextReach);
    uniforms.farol_reach.value = nextReach.texture;
    resolve.drawTo(frame, next);
    history.advance(viewProjection, frame.camera);
    picture.texture = next.texture;
    if (uniforms.farol_cells.value > 1) {
      if (frame.ownsPart && picture.isLast) frame.finer = next;
      uniforms.farol_history.value = next.texture;
      average.drawTo(frame, picture.target);
      picture.texture = picture.target.texture;
    }
    picture.encoded = false;
    picture.end(frame);
    this.buffer.reactive = now;
    frame.resources.put('motion', this.buffer);
    this.open = false;
  }

  dispose(): void {
    for (const history of this.histories) history.dispose();
    this.histories.length = 0;
    this.recent.clear();
    this.motion.dispose();
    this.distances.dispose();
    for (const pass of [this.near, this.resolve, this.average]) pass.dispose();
    this.shared?.dispose();
  }

  private drawMotion(frame: Frame): void {
    const { history, motion, viewProjection } = this;
    motion.render(frame, history.motions, history.frame + 1, history.viewProjection, this.shared!.target);
    const looks = looksOf(frame.queue) + surroundingsOf(frame.lights, frame.scene) * 11;
    const follows = !history.isEmpty;
    const moved = !viewProjection.equals(history.viewProjection);
    // a moving camera meets other materials and uploads; the clipping of history suffices for those
    const relit =
      history.lights.changed(frame.lights) ||
      (!moved && (frame.lights.uploadedBytes > 0 || sendsFields(frame) || looks !== history.materialHash));
    history.materialHash = looks;
    // frames with reactive pixels, now or before, count as changed
    const { reactive } = history;
    const covers = reactive.now !== null || reactive.previous !== null;
    const resized = history.sizeBefore.x !== frame.width || history.sizeBefore.y !== frame.height;
    const changed = moved || relit || resized || motion.changed || covers || frame.shadowMapsDrawn > 0;
    history.sure = follows && relit ? 0 : history.sure + 1;
    history.known = follows && !motion.known ? 0 : history.known + 1;
    history.quiet = follows && changed ? 0 : history.quiet + 1;
    const lit = history.sure > RELIT && frame.shadowMapsDrawn === 0 && !motion.undrawn;
    const belief = this.resolve.uniforms.farol_belief;
    if (!lit) belief.value = history.sure > RELIT || moved ? 1 : 0;
    else if (!follows || history.known <= MET) belief.value = 2;
    else belief.value = moved ? 4 : 3;
  }

  /** Sets the weights of this frame's samples in the history. */
  private setShares(frame: Frame): void {
    const { history, share } = this;
    const { gathered } = history;
    const still = !history.isEmpty && history.quiet > SETTLED;
    const { farol_weights, farol_cells, farol_gamma, farol_share } = this.resolve.uniforms;
    const weights = farol_weights.value;
    const cells = farol_cells.value;
    const parts = cells * cells;
    cellWeights(this.jitter.value, frame.width, frame.height, cells, still || history.isEmpty, weights);
    farol_gamma.value = still ? 0 : this.gamma;
    if (still) {
      for (let i = 0; i < 4; i++) {
        const weight = weights.getComponent(i);
        const sum = gathered.getComponent(i) + weight;
        weights.setComponent(i, sum > 0 ? weight / sum : 0);
        gathered.setComponent(i, Math.min(sum, SAMPLES / parts - weight));
      }
      return;
    }
    if (history.isEmpty) gathered.copy(weights);
    else gathered.setScalar(MOVED / parts);
    const first = 1 / (1 + history.count / parts);
    // with one cell a pixel, the cell gets a sample in every frame
    const least = 1 - (1 - share) ** (parts / 4);
    farol_share.value.set(Math.max(first, least), Math.max(first, least * STILL));
  }

  /** Draws the distances of surfaces, where depth does not give them. */
  private drawDistances(frame: Frame): void {
    const { farol_distances, farol_distanceDepth, farol_distancesStored } = this.resolve.uniforms;
    farol_distancesStored.value = frame.storesDistance ? storedKind(frame.camera) : 0;
    const target = frame.storesDistance ? this.distances.render(frame) : null;
    farol_distances.value = target?.texture ?? this.shared!.texture;
    farol_distanceDepth.value = target?.depthTexture ?? this.shared!.target.depthTexture;
  }

  private setDepthKind(frame: Frame): void {
    const { capabilities } = frame.webgl;
    const { far, projectionMatrix } = frame.camera as PerspectiveCamera;
    const { elements } = projectionMatrix;
    const logarithmic = capabilities.logarithmicDepthBuffer && elements[11] !== 0;
    const { farol_depthKind, farol_projectZ } = this.resolve.uniforms;
    farol_depthKind.value.set(capabilities.reversedDepthBuffer ? 1 : 0, logarithmic ? Math.log2(far + 1) : 0);
    farol_projectZ.value.set(elements[10], elements[14], elements[11], elements[15]);
  }

  private isCut(history: TemporalHistory, camera: Camera): boolean {
    const e = camera.matrixWorld.elements;
    const { forward } = history;
    const length = Math.hypot(e[8], e[9], e[10]) || 1;
    return (e[8] * forward.x + e[9] * forward.y + e[10] * forward.z) / length < CUT;
  }

  private historyOf(frame: Frame): TemporalHistory {
    const { camera, scene, width, height } = frame;
    const { histories } = this;
    let history: TemporalHistory | null = null;
    for (const one of histories) if (one.camera === camera && one.scene === scene) history = one;
    if (history === null) histories.push((history = new TemporalHistory(camera, scene as Object3D)));
    this.recent.use(history);
    const beyond = 2 * Math.max(width, height) > frame.webgl.capabilities.maxTextureSize;
    const scales = targetSizes.room > 0;
    const wanted = this.options.cells ?? (history.cellsOf(scales) || (width * height < LARGE ? 2 : 1));
    const cells = (this.pastCells.farol_cells.value = beyond ? 1 : wanted);
    // while a frame budget changes the resolution in steps, history of another size is used
    if (!history.hasSize(width, height, cells) && history.cellsOf(scales) !== cells) history.reset();
    history.setSize(width, height, cells);
    return history;
  }

  /** Stand-in for the host's camera, with a projection shifted by the jitter. */
  private viewOf(camera: Camera): Camera {
    let view = this.views.get(camera);
    if (view === undefined) {
      view = standInOf(camera, Camera.prototype);
      for (const name of ['projectionMatrix', 'projectionMatrixInverse'] as const) {
        Object.defineProperty(view, name, { value: new Matrix4(), writable: true, configurable: true });
      }
      this.views.set(camera, view);
    }
    const { x, y } = this.jitter.value;
    jitterProjection(view.projectionMatrix.copy(camera.projectionMatrix), x, y);
    view.projectionMatrixInverse.copy(view.projectionMatrix).invert();
    return view;
  }
}

/** Whether the frame has light fields and has uploaded light data, so that their lights may have changed. */
function sendsFields({ lights, uploadedBytes }: Frame): boolean {
  return lights.fields.length > 0 && uploadedBytes > 0;
}

/**
 * Shifts a projection by normalised device coordinates: a row operation, for perspective, orthographic and off-centre
 * projections alike.
 */
export function jitterProjection(projection: Matrix4, x: number, y: number): Matrix4 {
  const e = projection.elements;
  for (let column = 0; column < 16; column += 4) {
    e[column] += x * e[column + 3];
    e[column + 1] += y * e[column + 3];
  }
  return projection;
}
