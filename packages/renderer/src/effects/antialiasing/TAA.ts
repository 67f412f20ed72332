import {
  type Camera,
  type IUniform,
  Matrix4,
  type Object3D,
  type PerspectiveCamera,
  type Texture,
  Vector2,
  Vector4,
} from 'three';
import type { Frame } from '../../Frame';
import { FullscreenMesh } from '../../passes/FullscreenMesh';
import { PassMaterial } from '../../passes/PassMaterial';
import { addMicroShaders } from '../../microshaders/addMicroShaders';
import displayTransfer from '../displayTransfer.glsl?raw';
import type { FarolEffect } from '../../FarolEffect';
import { Picture } from '../Picture';
import { halton } from './halton';
import { jitterProjection } from './jitterProjection';
import { looksOf } from './looksOf';
import { MotionPass } from './MotionPass';
import taaResolve from './taaResolve.glsl?raw';
import { TemporalHistory } from './TemporalHistory';

/** Places in the pixel that the frames take in turns. */
const SAMPLES = 32;
/** Cameras whose past is kept; the one that has not drawn for longest gives way. */
const HISTORIES = 4;
/** Of `share`, in a pixel that does not move while others do. */
const STILL = 0.5;
/** A camera that turns by more than this from one frame to the next (cosine) shows another shot. */
const CUT = 0.7;

/**
 * Temporal anti-aliasing. Each frame is drawn with the camera moved within the pixel, by a view of the host's camera whose
 * projection alone differs, and mixed with the frames before, looked up where what a pixel shows was then: by the camera's
 * motion and depth, and of what moves by itself (objects, skins, morphs, instances, batches) by a pass of motion. Of the
 * past, only what is like the present pixel's neighbours is believed (variance clipping in YCoCg). A picture in which
 * nothing changes becomes the mean of 32 places in each pixel. Works with every technique.
 *
 * A change is seen in matrices, lights, and the colours and numbers of materials. Shaders and textures that move by
 * themselves are taken for changes always. Motion of what a shader of the host's moves is not known: it may ghost.
 * @see Karis 2014, High Quality Temporal Supersampling, https://advances.realtimerendering.com/s2014/
 * @see Salvi 2016, An Excursion in Temporal Supersampling (GDC)
 */
export class TAA implements FarolEffect {
  readonly name = 'TAA';
  /** Share of the new frame in a pixel that moves, half of that in one that does not: above 0, at most 1. Default 0.3. */
  share = 0.3;
  /** Standard deviations of its neighbours to which a pixel's past is clipped unless nothing changes. Default 1.25, above 0. */
  gamma = 1.25;
  private readonly histories: TemporalHistory[] = [];
  private history!: TemporalHistory;
  private readonly views = new WeakMap<Camera, Camera>();
  private readonly jitter = { value: new Vector2() };
  private readonly motion = new MotionPass(this.jitter.value);
  private readonly viewProjection = new Matrix4();
  private readonly picture: IUniform<Texture | null> = { value: null };
  private readonly depth: IUniform<Texture | null> = { value: null };
  private readonly past: IUniform<Texture | null> = { value: null };
  private readonly motionMap: IUniform<Texture | null> = { value: null };
  private readonly reproject = { value: new Matrix4() };
  private readonly depthKind = { value: new Vector2() };
  private readonly projectZ = { value: new Vector4() };
  private readonly encoded = { value: false };
  private readonly hasMotion = { value: false };
  private readonly shareOfNew = { value: new Vector2(1, 1) };
  private readonly clip = { value: 0 };
  private readonly triangle = new FullscreenMesh();
  private material: PassMaterial | null = null;
  private shared: Picture | null = null;
  private frames = 0;
  private contextLists: unknown = null;

  get bytes(): number {
    let bytes = this.motion.bytes + (this.shared?.bytes ?? 0);
    for (const history of this.histories) bytes += history.bytes;
    return bytes;
  }

  /** Forgets the past: after a cut, or when something has changed that cannot be seen in the scene's objects. */
  reset(): void {
    for (const history of this.histories) history.reset();
  }

  begin(frame: Frame): void {
    this.frames++;
    // three makes them anew when a lost context is back: what the targets held is gone
    if (this.contextLists !== frame.webgl.renderLists) this.reset();
    this.contextLists = frame.webgl.renderLists;
    this.shared = Picture.of(frame);
    this.shared.begin(frame);
    const { camera, width, height } = frame;
    const history = (this.history = this.historyOf(frame));
    this.viewProjection.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    if (this.isCut(history, camera)) history.reset();
    const sample = (history.count % SAMPLES) + 1;
    this.jitter.value.set(((halton(sample, 2) - 0.5) * 2) / width, ((halton(sample, 3) - 0.5) * 2) / height);
    frame.camera = this.viewOf(camera);
  }

  end(frame: Frame): void {
    const { history, motion } = this;
    const picture = this.shared!;
    this.material ??= this.makeMaterial(frame);
    const { viewProjection } = this;
    const still = this.drawMotion(frame);
    this.picture.value = picture.texture;
    this.depth.value = picture.target.depthTexture;
    this.past.value = history.texture;
    this.motionMap.value = motion.target?.texture ?? null;
    this.hasMotion.value = motion.drawn;
    this.encoded.value = picture.encoded;
    this.setDepthKind(frame);
    this.reproject.value.copy(viewProjection).invert().premultiply(history.viewProjection);
    const first = 1 / ((still ? history.still : history.count) + 1);
    const least = still ? 1 / SAMPLES : this.share;
    this.shareOfNew.value.set(Math.max(first, least), Math.max(first, still ? least : this.share * STILL));
    this.clip.value = still ? 0 : this.gamma;
    const target = history.next(frame.width, frame.height);
    frame.bind(target);
    frame.drawMesh(this.triangle, this.material);
    history.advance(viewProjection, frame.camera);
    picture.texture = target.texture;
    picture.encoded = false;
    picture.end(frame);
  }

  dispose(): void {
    for (const history of this.histories) history.dispose();
    this.histories.length = 0;
    this.motion.dispose();
    this.material?.dispose();
    this.material = null;
    this.shared?.dispose();
  }

  /** Draws the motion and tells whether nothing at all has changed. */
  private drawMotion(frame: Frame): boolean {
    const { history, motion, viewProjection } = this;
    motion.render(frame, history.motions, history.frame + 1, history.viewProjection, this.shared!.target);
    const looks = looksOf(frame.queue);
    const still =
      !history.isEmpty &&
      !motion.changed &&
      looks === history.looks &&
      frame.lights.uploadedBytes === 0 &&
      frame.shadowMapsDrawn === 0 &&
      viewProjection.equals(history.viewProjection);
    history.looks = looks;
    history.still = still ? history.still + 1 : history.isEmpty ? 0 : 3;
    return still;
  }

  private setDepthKind(frame: Frame): void {
    const { capabilities } = frame.webgl;
    const { far, projectionMatrix } = frame.camera as PerspectiveCamera;
    const { elements } = projectionMatrix;
    const logarithmic = capabilities.logarithmicDepthBuffer && elements[11] !== 0;
    this.depthKind.value.set(capabilities.reversedDepthBuffer ? 1 : 0, logarithmic ? Math.log2(far + 1) : 0);
    this.projectZ.value.set(elements[10], elements[14], elements[11], elements[15]);
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
    if (history === null) {
      if (histories.length >= HISTORIES) {
        histories.sort((one, other) => other.usedAt - one.usedAt);
        histories.pop()!.dispose();
      }
      histories.push((history = new TemporalHistory(camera, scene as Object3D)));
    }
    history.usedAt = this.frames;
    if (!history.hasSize(width, height)) history.reset();
    return history;
  }

  /** The host's camera with a projection moved by the jitter. */
  private viewOf(camera: Camera): Camera {
    let view = this.views.get(camera);
    if (view === undefined) {
      view = Object.create(camera) as Camera;
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

  private makeMaterial(frame: Frame): PassMaterial {
    addMicroShaders(frame.microshaders, { displayTransfer, taaResolve });
    return new PassMaterial(frame.microshaders, {
      name: 'Farol TAA',
      vertex: ['fullscreen'],
      fragment: ['taaResolve'],
      uniforms: {
        farol_picture: this.picture,
        farol_pictureDepth: this.depth,
        farol_history: this.past,
        farol_motionMap: this.motionMap,
        farol_reproject: this.reproject,
        farol_jitter: this.jitter,
        farol_depthKind: this.depthKind,
        farol_projectZ: this.projectZ,
        farol_encoded: this.encoded,
        farol_hasMotion: this.hasMotion,
        farol_share: this.shareOfNew,
        farol_gamma: this.clip,
      },
    });
  }
}
