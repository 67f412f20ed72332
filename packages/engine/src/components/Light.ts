import {
  AmbientLight,
  DirectionalLight,
  type HemisphereLight,
  type Light as ThreeLight,
  PointLight,
  SpotLight,
  Vector3,
} from 'three';
import type { Scene } from '../core/SceneGraph';
import { component } from '../fields/component';
import { applyLightFields } from './applyLightFields';
import { lightFields } from './lightFields';
import { SkyLight } from './SkyLight';

type AnyLight = AmbientLight | HemisphereLight | DirectionalLight | PointLight | SpotLight;

const makers: Record<string, () => AnyLight> = {
  ambient: () => new AmbientLight(),
  hemisphere: () => new SkyLight(),
  directional: () => new DirectionalLight(),
  point: () => new PointLight(),
  spot: () => new SpotLight(),
};

const softened = new WeakSet<Scene>();

/** Has the lights of a scene follow its softness of shadows. */
function followSoftness(scene: Scene): void {
  if (softened.has(scene)) return;
  softened.add(scene);
  scene.onChange((change) => {
    if (change.kind !== 'settings' || change.field !== 'shadowSoftness') return;
    for (const light of scene.componentsOf(Light)) light.applyFields();
  });
}

/**
 * Lets a GameObject light the scene. It owns a three light below the object's object3D. Directional and spot lights
 * shine along the object's front (-Z). What three's lights cannot say, the thesis's attenuations and extra colours,
 * goes to `three.userData.farol`, which @farol/renderer reads.
 */
export class Light extends component(lightFields) {
  static override readonly typeName: string = 'Light';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Ambient, hemisphere, directional, point or spot light.';

  private light: AnyLight | null = null;

  /** The three light; another one after a change of `type`. @throws Error when the component is on no GameObject */
  get three(): ThreeLight {
    if (!this.light) throw new Error('This Light is on no GameObject: add it with gameObject.addComponent.');
    return this.light;
  }

  /** Where the light is in the world, in metres. */
  get position(): Vector3 {
    return this.gameObject.transform.worldPosition;
  }

  /** Unit vector in the world along which a directional or spot light shines. */
  get direction(): Vector3 {
    return this.gameObject.transform.front;
  }

  /** How far the light reaches in metres; Infinity where it has no end. */
  get reach(): number {
    if (this.type !== 'point' && this.type !== 'spot') return Infinity;
    if (this.attenuation === 'near-far') return this.far;
    return this.range > 0 ? this.range : Infinity;
  }

  /** Puts the light at `eye` and points it at `target`, both in the world; with one argument it only turns. */
  lookAt(...args: Parameters<Light['gameObject']['transform']['lookAt']>): void {
    this.gameObject.transform.lookAt(...args);
  }

  override onAttach(): void {
    this.makeLight();
  }

  override onDetach(): void {
    this.dropLight();
  }

  override onEnterScene(scene: Scene): void {
    followSoftness(scene);
    if (scene.settings.shadowSoftness !== 1) this.applyFields();
  }

  override onActiveChanged(): void {
    if (this.light) this.light.visible = this.enabled;
  }

  override onFieldChanged(name: string): void {
    if (name === 'type') this.makeLight();
    else this.applyFields();
  }

  /** @internal Writes all fields to the three light. */
  applyFields(): void {
    applyLightFields(this, this.three, this.scene?.settings.shadowSoftness);
  }

  private makeLight(): void {
    this.dropLight();
    const light = makers[this.type]();
    light.position.set(0, 0, 0);
    light.visible = this.enabled;
    if (light instanceof DirectionalLight || light instanceof SpotLight) {
      light.target.position.set(0, 0, -1);
      light.add(light.target);
    }
    this.light = light;
    this.applyFields();
    this.gameObject.object3D.add(light);
  }

  private dropLight(): void {
    this.light?.removeFromParent();
    this.light?.dispose();
    this.light = null;
  }
}
