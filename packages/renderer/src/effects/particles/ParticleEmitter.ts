import {
  BufferGeometry,
  DataTexture,
  FloatType,
  Mesh,
  RawShaderMaterial,
  Sphere,
  type Camera,
  type InstancedBufferGeometry,
  type Material,
  type Object3D,
  type Scene,
  type WebGLRenderer,
} from 'three';
import { LightField } from '../../light-fields/LightField';
import type { LightTextures } from '../../light-fields/LightTextures';
import { checkParticleName, checkParticleSetting, settingNames } from './checkParticleSetting';
import { instancesOf } from './instancesOf';
import { particleDefaults } from './particleDefaults';
import type { ParticleSettings } from './ParticleSettings';
import { PendingSteps } from './PendingSteps';

/** Material that three draws an emitter with: nothing visible; Farol draws the particles. */
const nothing = new RawShaderMaterial({
  name: 'Farol particles',
  transparent: true,
  depthTest: false,
  depthWrite: false,
  vertexShader: 'void main() { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); }',
  fragmentShader: 'precision mediump float; void main() { gl_FragColor = vec4(0.0); }',
});
nothing.allowOverride = false;

/** Maximum number of lights of an emitter, as of a LightField. */
const MOST_LIGHTS = 2 ** 18;
/** Texture of one light with a range of 0 m, which lights nothing. */
const DARK = new DataTexture(new Float32Array(4), 1, 1, undefined, FloatType);
DARK.needsUpdate = true;
const NO_LIGHTS: LightTextures = { sphere: DARK, emission: DARK };

/** Actions on changes of settings; settings not listed are read each frame. */
const CONSEQUENCES: { readonly [Name in keyof ParticleSettings]?: (emitter: ParticleEmitter) => void } = {
  capacity(emitter) {
    emitter.restart();
    emitter.takeLights();
  },
  lightEvery: (emitter) => emitter.takeLights(),
  seed: (emitter) => emitter.restart(),
  shape: (emitter) => emitter.restart(),
  sizeOverLife: (emitter) => emitter.curvesVersion++,
  colorOverLife: (emitter) => emitter.curvesVersion++,
  spinOverLife: (emitter) => emitter.curvesVersion++,
  render: (emitter) => emitter.takeGeometry(),
  particleGeometry: (emitter) => emitter.takeGeometry(),
};

/** Mesh typed with the settings as properties, whose accessors are on `ParticleEmitter.prototype`. */
const MeshWithSettings = Mesh as unknown as new (
  geometry: BufferGeometry,
  material: Material,
) => Mesh & ParticleSettings;

/**
 * Emits particles that the GPU simulates. Drawn with every technique if `farol.effects` contains the effect `Particles`;
 * invisible in stock three. Each setting is a property that may be set at any time. Particles begin at the emitter's
 * transform; after that they stay in the world. Only `step` advances the time. The same seed, settings, transforms and
 * steps give the same particles. After a lost context they begin anew.
 *
 * @example
 * const fire = new ParticleEmitter({ ...particlePresets.fire, rate: 200 });
 * scene.add(fire);
 * farol.effects = [new Particles()];
 * // in each frame
 * fire.step(seconds);
 * farol.render(scene, camera);
 */
export class ParticleEmitter extends MeshWithSettings {
  readonly isParticleEmitter = true;
  /** Whether new particles begin; living ones continue in any case. Default true. */
  emitting = true;
  /** Version of curves and gradients, raised by each change. @internal */
  curvesVersion = 0;
  /** Number of restarts so far. @internal */
  restarts = 0;
  /** @internal */
  readonly pending = new PendingSteps();
  /** Set by the effect `Particles`, called before the emitter is drawn. @internal */
  prepareDraw: ((emitter: ParticleEmitter) => void) | null = null;
  /** @internal */
  readonly values: ParticleSettings;
  private field: LightField | null = null;
  private hasBegun = false;
  private prewarmed = 0;
  /** Capacity for which a warning was given; 0 for none. */
  private toldOf = 0;

  /** @param settings - settings that differ from the defaults @throws RangeError that names an invalid setting */
  constructor(settings: Partial<ParticleSettings> = {}) {
    super(new BufferGeometry(), nothing);
    this.name = 'ParticleEmitter';
    this.frustumCulled = false;
    this.values = { ...particleDefaults };
    this.takeGeometry();
    this.set(settings);
  }

  /** Time since the last restart (s). */
  get time(): number {
    return this.pending.schedule.time - this.prewarmed;
  }

  /** Whether no particle begins any more: `duration` is over, without `loop`. */
  get isOver(): boolean {
    return this.pending.schedule.isOver;
  }

  /** The particles' lights, a child whose `color` and `intensity` scale them; null where `lightEvery` is 0. */
  get lights(): LightField | null {
    return this.field;
  }

  /** Copy of all settings. */
  get settings(): ParticleSettings {
    return { ...this.values, receiveShadow: this.receiveShadow };
  }

  /**
   * Sets several settings.
   * @throws RangeError that names the first invalid one, with those before it set; for an unknown name, with none set
   */
  set(settings: Partial<ParticleSettings>): this {
    for (const name of Object.keys(settings)) checkParticleName(this.owner, name);
    for (const name of settingNames)
      if (settings[name] !== undefined) (this as Record<string, unknown>)[name] = settings[name];
    return this;
  }

  /**
   * Advances the time: long steps are split into parts of at most 1/30 s, with the emitter's transform interpolated. The GPU
   * simulates in the next frame that draws the emitter.
   * @param seconds - time to add (s), 0 or more
   * @throws RangeError for any other number
   */
  step(seconds: number): void {
    if (!(seconds >= 0 && seconds < Infinity))
      throw new RangeError(`${this.owner}: step(${seconds}); give a finite number of seconds of at least 0.`);
    this.updateWorldMatrix(true, false);
    this.begin();
    if (seconds > 0) this.pending.advance(seconds, this.values, this.matrixWorld, this.emitting);
    if (this.pending.schedule.wasFull && this.toldOf !== this.values.capacity) this.tellFull();
  }

  /** Removes all particles and begins anew at the time 0, with the same seed. */
  restart(): void {
    this.hasBegun = false;
    this.restarts++;
    this.pending.restart(this.matrixWorld);
    this.prewarmed = 0;
  }

  /** Completes a restart, if one is due. The world matrix must be up to date. @internal */
  begin(): void {
    if (this.hasBegun) return;
    this.hasBegun = true;
    const { pending, values } = this;
    pending.restart(this.matrixWorld);
    this.prewarmed = values.prewarm;
    if (values.prewarm > 0) pending.advance(values.prewarm, values, this.matrixWorld, this.emitting);
  }

  /** Frees the emitter's GPU resources; a later frame that draws it creates them and restarts it. */
  override dispose(): void {
    super.dispose();
    this.geometry.dispose();
    this.restart();
  }

  override copy(source: this, recursive?: boolean): this {
    const { geometry } = this;
    super.copy(source, false);
    this.geometry = geometry;
    if (recursive !== false) for (const child of source.children) if (child !== source.field) this.add(child.clone());
    this.emitting = source.emitting;
    return this.set(source.settings);
  }

  /** Updates matrices, and copies the emitter's layers to its lights, so that cameras that see the particles see their light. */
  override updateMatrixWorld(force?: boolean): void {
    if (this.field !== null) this.field.layers.mask = this.layers.mask;
    super.updateMatrixWorld(force);
  }

  /** Does nothing: raycasters do not hit particles. */
  override raycast(): void {}

  override onBeforeRender(
    _webgl: WebGLRenderer,
    _scene: Scene,
    _camera: Camera,
    _geometry: BufferGeometry,
    _material: Material,
    _group: unknown,
  ): void {
    this.prepareDraw?.(this);
  }

  /** Creates or removes the LightField of the particles' lights. @internal */
  takeLights(): void {
    const { capacity, lightEvery } = this.values;
    const count = lightEvery > 0 ? Math.min(MOST_LIGHTS, Math.ceil(capacity / lightEvery)) : 0;
    if (count === (this.field?.capacity ?? 0)) return;
    this.field?.removeFromParent();
    this.field = count > 0 ? new LightField(count, { textures: NO_LIGHTS }) : null;
    if (this.field === null) return;
    this.field.name = 'Lights of particles';
    // the field's matrix stays the identity: particles' positions are in world space, not in the emitter's
    this.field.matrixAutoUpdate = this.field.matrixWorldAutoUpdate = false;
    this.add(this.field);
  }

  /** Textures that hold the lights of particles; null when no light is on. @internal */
  setLightTextures(textures: LightTextures | null): void {
    if (this.field !== null) this.field.textures = textures ?? NO_LIGHTS;
  }

  /** Creates the geometry: vertices without attributes, or instances of a mesh. @internal */
  takeGeometry(): void {
    const { render, particleGeometry } = this.values;
    this.geometry.dispose();
    if (render === 'mesh') this.geometry = instancesOf(particleGeometry);
    else {
      this.geometry = new BufferGeometry();
      this.geometry.setDrawRange(0, 0);
    }
    this.geometry.boundingSphere = new Sphere();
  }

  /** Draws no particles until an effect sets their number. @internal */
  hide(): void {
    const { geometry } = this;
    this.setLightTextures(null);
    if ((geometry as InstancedBufferGeometry).isInstancedBufferGeometry === true)
      (geometry as InstancedBufferGeometry).instanceCount = 0;
    else geometry.setDrawRange(0, 0);
  }

  private tellFull(): void {
    const { capacity, rate, life, bursts } = this.values;
    this.toldOf = capacity;
    const enough = Math.ceil(rate * life[1]) + bursts.reduce((sum, { count }) => sum + count, 0);
    // no warning if the capacity suffices for `rate`: there is room again once the particles that ended are removed
    if (capacity >= enough) return;
    console.warn(
      `${this.owner}: capacity ${capacity} is reached, and no more particles begin; set it to ${enough} or more.`,
    );
  }

  /** Name of the emitter, for errors. @internal */
  get owner(): string {
    return this.name === '' || this.name === 'ParticleEmitter' ? 'ParticleEmitter' : `ParticleEmitter "${this.name}"`;
  }
}

for (const name of settingNames) {
  // receiveShadow stays the plain property that every Object3D has
  if (name === 'receiveShadow') continue;
  Object.defineProperty(ParticleEmitter.prototype, name, {
    get(this: ParticleEmitter) {
      return this.values[name];
    },
    set(this: ParticleEmitter, value: never) {
      checkParticleSetting(this.owner, name, value);
      if (this.values[name] === value) return;
      (this.values[name] as unknown) = value;
      CONSEQUENCES[name]?.(this);
    },
    enumerable: true,
    configurable: true,
  });
}

export type EmitterObject = Object3D & Partial<Pick<ParticleEmitter, 'isParticleEmitter'>>;
