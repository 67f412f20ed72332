import { type Camera, Color, type Data3DTexture, Vector2, Vector3, Vector4 } from 'three';
import { drawBuffersOf, lacksFloatTargets } from '../../gpu/checkDevice';
import { isSoftwareRasteriser } from '../../gpu/graphicsDevice';
import type { FullscreenPass } from '../../gpu/FullscreenPass';
import type { FroxelBuffer } from '../../frame/EffectBuffers';
import type { FarolEffect } from '../../frame/FarolEffect';
import type { Frame } from '../../frame/Frame';
import { RecentlyUsed } from '../../frame/RecentlyUsed';
import type { RenderItem } from '../../frame/RenderItem';
import type { TwinKind } from '../../materials/TwinKind';
import type { MicroShaderRegistry } from '../../microshaders';
import { parseMicroShader } from '../../microshaders/parseMicroShader';
import { isDepthReversed } from '../../three/state';
import { fogBackgroundPass, fogIntegratePass, fogLightsPass, fogScatterPass } from './fogPasses';
import { FogHistory } from './FogHistory';
import { FogMedium } from './FogMedium';
import { foggedTwin, isFogged } from './foggedTwin';
import { type FogWork, fogWork, turnsOf } from './fogWork';
import { checkFroxels, EXPONENT, type Froxels, sliceDepth, sliceScale } from './froxels';
import { FroxelTexture } from './FroxelTexture';
import { halton } from '../antialiasing/halton';
import mediaOn from './mediaOn.glsl?raw';

/** Registries whose shaders have code for fog; it is never removed, so that nothing is compiled twice. */
const adapted = new WeakSet<MicroShaderRegistry>();

/** Whether two scales of projections are equal up to rounding. */
const near = (a: number, b: number): boolean => Math.abs(a - b) < 1e-6;

/**
 * Fog lit by the scene's lights, with their shadows, cookies and profiles: halos, beams and shafts. Over opaque and
 * transparent objects and the background, with every technique. Local fog: {@link FogVolume}. The view is divided into
 * froxels, cells of pixels and depth; the light in each is computed once a frame, averaged with earlier frames', and
 * summed from the eye on. Fog ends at `distance`. Needs a PerspectiveCamera; with others it is left out with a warning.
 * Materials with `fog: false`, node materials and shaders that write their own outputs are drawn without it.
 *
 * @example
 * const fog = new VolumetricFog();
 * fog.density = 0.05;
 * farol.effects = [fog];
 * @see Wronski 2014, Volumetric Fog (SIGGRAPH, Advances in Real-Time Rendering); Hillaire 2015, Physically Based and Unified
 *   Volumetric Rendering in Frostbite
 */
export class VolumetricFog implements FarolEffect, FroxelBuffer {
  readonly name = 'volumetric fog';
  readonly after = ['opaque'] as const;
  readonly lacks = lacksFloatTargets;
  /** Extinction coefficient (1/m): a share of 1 - 1/e of the light is lost over 1 / density. Default 0.03. */
  density = 0.03;
  /** Share of the extinguished light that is scattered, not absorbed, by colour (linear). Default white. */
  readonly albedo = new Color(1, 1, 1);
  /** Mean cosine of scattering, above -1 (backward), below 1 (forward); above 0, lights have halos. Default 0.3. */
  anisotropy = 0.3;
  /** Height (m, world space) up to which the fog has its full density. Default 0. */
  height = 0;
  /** Distance (m) above `height` over which the density falls to 1/e; 0: no fall. Default 0. */
  falloff = 0;
  /** Distance along the view at which fog ends (m), above 0. Default 100. */
  distance = 100;
  /** Strength of clouds (noise) in the density, 0 to 1. Default 0. */
  noise = 0;
  /** Size of the clouds (m), above 0. Default 4. */
  noiseSize = 4;
  /** Velocity of the clouds (m/s, world space). Default 0.5 m/s along x. */
  readonly wind = new Vector3(0.5, 0, 0);
  /** Time (s) at which the drifting clouds are drawn; null: the page's clock. Default null. */
  time: number | null = null;
  /** Number of frames averaged while something moves; 1 for no averaging. Default 12. */
  frames = 12;
  /** Froxels of the last frame, see `FroxelBuffer`; null before the first. */
  scattered: Data3DTexture | null = null;
  private chosen: Froxels | null = null;
  private work: FogWork = fogWork(false, false);
  private isSoftware: boolean | null = null;
  /** Number of frames in which each slice is computed once. */
  private turns = 1;
  private isOn = false;
  private isMade = false;
  private hasWarned = false;
  private layers = 0;
  private readonly histories = new Map<Camera, FogHistory>();
  private readonly used = new RecentlyUsed<Camera>((camera) => this.forget(camera));
  private readonly integrated = new FroxelTexture();
  private readonly medium = new FogMedium();
  private readonly twins = new Map<TwinKind, TwinKind>();
  private readonly grid = {
    farol_fogGrid: { value: new Int32Array(4) },
    farol_fogSlices: { value: new Vector2() },
    farol_fogRay: { value: new Vector4() },
    farol_fogBlocks: { value: new Int32Array(2) },
  };
  private readonly lights = fogLightsPass(this.grid);
  private readonly background = fogBackgroundPass();
  private scatter: ReturnType<typeof fogScatterPass> | null = null;
  private integrate: ReturnType<typeof fogIntegratePass> | null = null;
  private frame: Frame | null = null;
  /** The frame's camera, before an effect such as TAA moves it. */
  private camera!: Camera;
  private readonly viewport = new Vector4();

  /**
   * Numbers of froxels across, up and in depth (a multiple of 8); null for the default. Default by the device, from the first
   * frame on: `fogQualities.medium`, 160 × 90 × 64; `low` with the quality 'lite'; `lowest` with a software rasteriser.
   * @throws RangeError for numbers that a grid cannot have
   */
  get froxels(): Froxels {
    return this.chosen ?? this.work.froxels;
  }

  set froxels(froxels: Froxels | null) {
    this.chosen = froxels === null ? null : checkFroxels(froxels);
  }

  /** Number of frames after which a still scene's picture hardly changes, on the device of the last frame. */
  get stillFrames(): number {
    return Math.max(this.work.stillFrames, 2 * this.turns);
  }

  get bytes(): number {
    let bytes = this.integrated.bytes + this.lights.bytes;
    for (const history of this.histories.values()) bytes += history.bytes;
    return bytes;
  }

  begin(frame: Frame): void {
    const { microshaders, uniforms } = frame;
    this.frame = frame;
    this.camera = frame.camera;
    uniforms.farol_mediaSpace.value[7] = 0;
    this.isMade = false;
    this.isOn = frame.camera.projectionMatrix.elements[11] !== 0;
    if (!this.isOn) return this.warn();
    frame.hasMedia = true;
    if (adapted.has(microshaders)) return;
    adapted.add(microshaders);
    microshaders.swap('media', parseMicroShader('media', mediaOn));
  }

  compute(frame: Frame): void {
    if (!this.isOn) return;
    const { webgl, uniforms } = frame;
    const bound = webgl.getRenderTarget();
    const isTransmission = bound !== frame.target;
    const isFirst = !this.isMade;
    if (isTransmission) webgl.getCurrentViewport(this.viewport);
    else this.viewport.copy(frame.viewport);
    if (isFirst) {
      this.make(frame);
      if (isTransmission) webgl.setRenderTarget(bound);
      else frame.bindTarget();
    }
    const { x, y, z, w } = this.viewport;
    const space = uniforms.farol_mediaSpace.value;
    space[0] = x;
    space[1] = y;
    space[2] = 1 / z;
    space[3] = 1 / w;
    if (isFirst || !isTransmission) return;
    // three's transmission target holds all opaque objects by now
    this.cover(frame);
    frame.resolveTransmission();
  }

  adapt(kind: TwinKind, item: RenderItem): TwinKind {
    if (!this.isOn || !isFogged(kind, item.material)) return kind;
    let twin = this.twins.get(kind);
    if (twin === undefined) this.twins.set(kind, (twin = foggedTwin(kind)));
    return twin;
  }

  render(frame: Frame): void {
    if (this.isOn && frame.target?.depthBuffer !== false) this.cover(frame);
  }

  end(frame: Frame): void {
    frame.uniforms.farol_mediaSpace.value[7] = 0;
  }

  reset(): void {
    for (const history of this.histories.values()) history.restart();
  }

  dispose(): void {
    for (const history of this.histories.values()) history.dispose();
    this.histories.clear();
    this.used.clear();
    this.integrated.dispose();
    this.lights.dispose();
    this.background.dispose();
    this.scatter?.dispose();
    this.integrate?.dispose();
    this.scatter = this.integrate = null;
    this.scattered = null;
    if (this.frame === null) return;
    this.frame.uniforms.farol_mediaSpace.value[7] = 0;
    this.frame.uniforms.farol_media.value = null;
    this.frame = null;
  }

  /** Draws fog over the farthest depth of the bound target: the background, by whatever it was drawn. */
  private cover(frame: Frame): void {
    const { uniforms } = this.background;
    uniforms.farol_farthest.value = isDepthReversed(frame.webgl) ? 0 : 1;
    this.background.draw(frame);
  }

  /** Depth (m) of a slice's edge, 0 (the eye) to the number of slices. */
  depthOf(edge: number): number {
    return sliceDepth(edge, this.froxels[2], this.distance);
  }

  /** Draws the frame's froxels; restores the bound target. */
  private make(frame: Frame): void {
    this.isMade = true;
    const { grid, integrated, medium } = this;
    const { camera, uniforms } = frame;
    const layers = (this.layers ||= drawBuffersOf(frame.gl) >= 8 ? 8 : 4);
    this.isSoftware ??= isSoftwareRasteriser(frame.gl);
    this.work = fogWork(frame.isLite, this.isSoftware);
    const size = this.froxels;
    const history = this.historyOf(this.camera);
    // writes the lights of light fields to the light table, which the renderer would do later
    if (frame.fields?.isDrawn === false) frame.fields.render();
    medium.read(this, frame);
    const lights = frame.lights.directionals.length + frame.lights.unboundeds.length + frame.lights.listed;
    // without averaging, each frame computes all slices
    this.turns = this.frames <= 1 ? 1 : turnsOf(size, lights, this.work.sums, layers);
    this.note(frame, history, lights);
    grid.farol_fogGrid.value.set(size);
    grid.farol_fogSlices.value.set(sliceScale(this.distance), EXPONENT);
    const { elements: e } = camera.projectionMatrix;
    grid.farol_fogRay.value.set(1 / e[0], 1 / e[5], e[8], e[9]);
    this.findLights(frame, size);
    history.current.fit(size);
    integrated.fit(size);
    const scatter = (this.scatter ??= fogScatterPass(grid, medium.uniforms, layers));
    this.setScatter(scatter.uniforms, frame, history);
    this.drawSlices(frame, scatter, history.current, size[2]);
    const integrate = (this.integrate ??= fogIntegratePass(grid, layers));
    integrate.uniforms.farol_froxels.value = history.current.texture;
    this.drawSlices(frame, integrate, integrated, size[2]);
    this.scattered = history.current.texture;
    frame.resources.put('froxels', this);
    history.advance(camera);
    uniforms.farol_media.value = integrated.texture;
    const space = uniforms.farol_mediaSpace.value;
    space[4] = 1 / sliceScale(this.distance);
    space[5] = 1 / EXPONENT;
    space[6] = size[2];
    space[7] = 1;
  }

  private drawSlices(frame: Frame, pass: FullscreenPass, to: FroxelTexture, slices: number): void {
    const { layers } = this;
    for (let first = 0; first < slices; first += layers) {
      this.grid.farol_fogGrid.value[3] = first;
      to.bind(frame, first / layers, layers);
      pass.draw(frame);
    }
  }

  /** Finds which lights may reach each block of froxels. */
  private findLights(frame: Frame, [across, up, away]: Froxels): void {
    const { farol_fogBlocks } = this.grid;
    const x = (farol_fogBlocks.value[0] = Math.ceil(across / 8));
    const y = (farol_fogBlocks.value[1] = Math.ceil(up / 8));
    const quads = Math.max(1, Math.ceil(frame.lights.listed / 128));
    this.lights.drawToOwn(frame, (x * away) / 4, y * quads);
  }

  private setScatter(
    uniforms: ReturnType<typeof fogScatterPass>['uniforms'],
    { camera }: Frame,
    history: FogHistory,
  ): void {
    const { turns } = this;
    const { frame } = history;
    uniforms.farol_fogLights.value = this.lights.texture;
    uniforms.farol_fogBefore.value = history.previous.texture;
    uniforms.farol_fogToWorld.value.copy(camera.matrixWorld);
    uniforms.farol_fogToBefore.value.multiplyMatrices(history.view, camera.matrixWorld);
    uniforms.farol_fogRayBefore.value.copy(history.ray);
    uniforms.farol_anisotropy.value = Math.min(0.99, Math.max(-0.99, this.anisotropy));
    const share = uniforms.farol_fogShare.value;
    if (this.frames <= 1) share.set(0, 0, 0, 1);
    else {
      const index = (Math.floor(frame / turns) % 1024) + 1;
      share.set(halton(index, 2) - 0.5, halton(index, 3) - 0.5, halton(index, 5) - 0.5, history.share);
    }
    uniforms.farol_fogTurn.value[0] = turns;
    uniforms.farol_fogTurn.value[1] = frame % turns;
    uniforms.farol_fogOtherShare.value = history.otherShare;
  }

  /** Passes this frame's changes to the history, which sets the number of frames in its mean by them. */
  private note({ camera, lights, fields, shadowMapsDrawn }: Frame, history: FogHistory, lightCount: number): void {
    const { medium, turns, work } = this;
    if (history.settingsHash !== medium.settingsHash) history.count = 0;
    history.settingsHash = medium.settingsHash;
    const { elements: e } = camera.projectionMatrix;
    const { x, y } = history.ray;
    const isStill = !medium.drifts && fields === null && shadowMapsDrawn === 0;
    const isSeenAlike = history.view.equals(camera.matrixWorldInverse) && near(e[0], x) && near(e[5], y);
    // a moving camera sees other lights, which is no change of lights
    const isOther = isSeenAlike && lightCount !== history.lightCount;
    history.lightCount = lightCount;
    const changed = history.lights.changed(lights) || isOther;
    history.note(this.frames, changed, isStill && isSeenAlike, turns, work.forgets);
  }

  private historyOf(camera: Camera): FogHistory {
    this.used.use(camera);
    let history = this.histories.get(camera);
    if (history === undefined) this.histories.set(camera, (history = new FogHistory()));
    return history;
  }

  private forget(camera: Camera): void {
    this.histories.get(camera)?.dispose();
    this.histories.delete(camera);
  }

  private warn(): void {
    if (!this.hasWarned)
      console.warn('Farol: volumetric fog is left out, since it needs perspective; use a PerspectiveCamera.');
    this.hasWarned = true;
  }
}
