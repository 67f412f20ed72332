import type { AssetType } from '@farol/editing/fields';
import type { ParticleEmitter as ThreeEmitter } from '@farol/renderer/particles';
import { type BufferGeometry, Mesh, type Object3D, type Texture } from 'three';
import { component } from '../core/Component';
import type { NewObject } from '../core/NewObject';
import type { RequiredEffect } from '../core/RequiredEffect';
import type { Scene } from '../core/Scene';
import { LightGroups } from './lightGroups';
import { ObjectRenderer } from './ObjectRenderer';
import { particleCode, particlePreset, particlesEffect } from './particleCode';
import { type ColliderPose, ColliderPoses } from './ColliderPoses';
import { particleFields } from './particleFields';
import { colliderObjects, type ParticleParts } from './particleSettings';

/** Difference below which scene time and emitter time count as equal (s). */
const SAME_TIME = 1e-4;

/**
 * Emits particles that the GPU simulates, and that may be lights: `ParticleEmitter` of @farol/renderer/particles,
 * fetched when a scene first has one; an `App` switches the effect on that draws it. While the scene plays, particles
 * follow its time, and restart with it from the seed: equal times give equal particles.
 */
export class ParticleEmitter extends component(particleFields) {
  static override readonly typeName: string = 'ParticleEmitter';
  static override readonly icon: string = 'particles';
  static override readonly help: string = 'Particles such as fire, smoke and sparks, which may light the scene.';
  static override readonly newObjects: readonly NewObject[] = [
    { label: 'Emitter', name: 'Particles', group: 'particles' },
    { label: 'Fire', group: 'particles', values: () => particlePreset('fire') },
    { label: 'Smoke', group: 'particles', values: () => particlePreset('smoke') },
    { label: 'Sparks', group: 'particles', values: () => particlePreset('sparks') },
    { label: 'Fireflies', group: 'particles', values: () => particlePreset('fireflies') },
  ];
  static override readonly effect: RequiredEffect = particlesEffect;
  static override readonly callable: readonly string[] = ['restart', 'emit', 'stop'];

  private emitter: ThreeEmitter | null = null;
  /** Scene time at which emission began (s). */
  private beganAt = 0;
  private readonly colliders = new ColliderPoses();
  private readonly colliderObjects: (Object3D | null)[] = colliderObjects.map(() => null);
  private readonly parts: { -readonly [K in keyof ParticleParts]: ParticleParts[K] } = {
    colliders: [],
    surface: null,
    mesh: null,
    texture: null,
  };

  /** The emitter below the GameObject's object3D; null outside a scene, and until the late code is loaded. */
  get three(): ThreeEmitter | null {
    return this.emitter;
  }

  /** Poses of the colliders that particles bounce off. */
  get colliderPoses(): readonly ColliderPose[] {
    return this.parts.colliders;
  }

  /** Removes all particles and restarts the emission from the seed. */
  restart(): void {
    this.beganAt = this.scene?.time ?? 0;
    this.emitter?.restart();
  }

  /** Starts emission. */
  emit(): void {
    this.simulate('emitting', true);
  }

  /** Stops emission; living particles continue. */
  stop(): void {
    this.simulate('emitting', false);
  }

  /** Advances particles by a time (s) independent of the scene's, as editors do while nothing plays. */
  advance(seconds: number): void {
    this.followSurface();
    this.followColliders();
    this.emitter?.step(seconds);
  }

  override onEnterScene(scene: Scene): void {
    this.beganAt = scene.time;
    LightGroups.of(scene).add(this);
    LightGroups.of(scene).join(this, this.group);
    this.make(scene);
  }

  override onLeaveScene(scene: Scene): void {
    LightGroups.of(scene).remove(this);
    this.emitter?.removeFromParent();
    this.emitter?.dispose();
    this.emitter = null;
    for (const name of ['mesh', 'texture'] as const) this.useAsset(scene, name, null);
    this.parts.surface = null;
  }

  override onFieldChanged(name: string): void {
    const { scene, emitter } = this;
    if (name === 'group' && scene) LightGroups.of(scene).join(this, this.group);
    if (!scene || !emitter) return;
    if (name === 'group') return this.followGroup();
    if (name === 'mesh' || name === 'texture') return this.fetchPart(scene, name);
    if (name === 'surface' || name === 'shape') this.parts.surface = this.findSurface();
    emitter.emitting = this.emitting;
    this.followColliders();
    this.apply(name);
  }

  override onActiveChanged(): void {
    if (this.isActive) this.restart();
    this.show();
  }

  override update(deltaSeconds: number, time: number): void {
    const { emitter } = this;
    if (!emitter) return;
    this.followSurface();
    this.followColliders();
    // when the scene's time was set back, emission begins at the present time
    if (time < this.beganAt) this.beganAt = time;
    const due = time - this.beganAt;
    if (Math.abs(emitter.time + deltaSeconds - due) < SAME_TIME) {
      // no step of 0 s: it would prewarm the emitter, which may never be drawn
      if (deltaSeconds > 0) emitter.step(deltaSeconds);
      return;
    }
    // the time jumped: the emitter was previewed before, or the scene was moved to a time
    emitter.restart();
    if (due > 0) emitter.step(due);
  }

  /** @internal Called when the choice of lights that are shown alone (solo) has changed. */
  followSolo(): void {
    const lights = this.emitter?.lights;
    if (lights && this.scene) lights.visible = !LightGroups.of(this.scene).isMuted(this);
  }

  /** @internal Called when the factors of the lights' group change. */
  followGroup(): void {
    const { emitter, scene, group, lightIntensity } = this;
    if (!emitter || !scene) return;
    emitter.lightIntensity = lightIntensity * (LightGroups.of(scene).masterOf(group)?.dimmer ?? 1);
  }

  private make(scene: Scene): void {
    const code = particleCode.codeOr(() => {
      if (this.scene === scene && this.emitter === null) this.make(scene);
    });
    if (code === null) return;
    const emitter = (this.emitter = new code.ParticleEmitter());
    emitter.name = this.gameObject.name;
    this.gameObject.object3D.add(emitter);
    this.parts.surface = this.findSurface();
    this.followColliders();
    emitter.set(code.particleSettings(this, this.parts));
    emitter.emitting = this.emitting;
    this.followGroup();
    for (const name of ['mesh', 'texture'] as const) if (this[name] !== null) this.fetchPart(scene, name);
    this.show();
    const due = scene.time - this.beganAt;
    if (due > 0) emitter.step(due);
  }

  private show(): void {
    if (this.emitter) this.emitter.visible = this.enabled;
    this.followSolo();
  }

  /** Applies the emitter setting that a field belongs to. */
  private apply(field: string): void {
    const { emitter, scene } = this;
    if (!emitter || !scene) return;
    const { time } = emitter;
    emitter.set(particleCode.code!.changedSetting(field, this, this.parts));
    if (field === 'lightIntensity') this.followGroup();
    this.followSolo();
    // a setting that restarts the emitter makes emission begin at the present time
    if (time > 0 && emitter.time === 0) this.beganAt = scene.time;
    else if (time === 0 && emitter.prewarm > 0) emitter.restart();
  }

  private fetchPart(scene: Scene, name: 'mesh' | 'texture'): void {
    const asset = this[name];
    const type: AssetType = name;
    this.useAsset(scene, name, null);
    if (asset === null) return this.apply(name);
    scene.assets.whenReady(type, asset, () => {
      if (this.scene !== scene || this[name] !== asset || !this.emitter) return;
      this.useAsset(scene, name, name === 'mesh' ? scene.assets.mesh(asset) : scene.assets.texture(asset));
      this.apply(name);
    });
    if (this.parts[name] === null) this.apply(name);
  }

  /** Registers as user of an asset, and unregisters from the previous one. */
  private useAsset(scene: Scene, name: 'mesh' | 'texture', asset: BufferGeometry | Texture | null): void {
    const { uses } = scene.assets;
    const before = this.parts[name];
    if (asset) uses.acquire(asset);
    if (before) uses.release(before);
    this.parts[name] = asset as never;
  }

  /** Updates the mesh on which particles begin, after the mesh was loaded or removed. */
  private followSurface(): void {
    if (this.shape !== 'mesh') return;
    const { surface } = this.parts;
    if (surface?.parent) return;
    const found = this.findSurface();
    if (found === surface) return;
    this.parts.surface = found;
    this.apply('surface');
  }

  /** Updates the poses of the objects that particles bounce off. */
  private followColliders(): void {
    const { colliderObjects: objects, scene } = this;
    for (let i = 0; i < objects.length; i++) {
      const id = this.collides ? this[colliderObjects[i]] : null;
      objects[i] = id === null ? null : (scene?.findById(id)?.object3D ?? null);
    }
    if (!this.colliders.follow(objects)) return;
    this.parts.colliders = this.colliders.poses;
    this.apply('collides');
  }

  private findSurface(): Mesh | null {
    if (this.shape !== 'mesh') return null;
    const { surface, scene } = this;
    const object = surface === null ? this.gameObject : (scene?.findById(surface) ?? null);
    const own = object?.getComponent(ObjectRenderer)?.three;
    if (own || !object) return own ?? null;
    let found: Mesh | null = null;
    object.object3D.traverse((each) => {
      if (!found && each instanceof Mesh && !('isParticleEmitter' in each)) found = each;
    });
    return found;
  }
}
