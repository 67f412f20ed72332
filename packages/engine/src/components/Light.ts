import {
  AmbientLight,
  DirectionalLight,
  type HemisphereLight,
  type Light as ThreeLight,
  PointLight,
  RectAreaLight,
  SpotLight,
  Vector3,
} from 'three';
import type { Vector3Tuple } from '@farol/editing/fields';
import { storeLightOptions } from '@farol/renderer/light-options';
import type { PhotometricProfile } from '@farol/renderer/light-profiles';
import type { NewObject } from '../core/NewObject';
import type { Scene } from '../core/Scene';
import { component } from '../core/Component';
import { applyLightFields, colourOfLight } from './applyLightFields';
import { lightFields } from './lightFields';
import { type LightMaster, LightGroups, tintLight } from './lightGroups';
import { newLights } from './newLights';
import { SkyLight } from './SkyLight';

type AnyLight = AmbientLight | HemisphereLight | DirectionalLight | PointLight | SpotLight | RectAreaLight;

const makers: Record<string, () => AnyLight> = {
  ambient: () => new AmbientLight(),
  hemisphere: () => new SkyLight(),
  directional: () => new DirectionalLight(),
  point: () => new PointLight(),
  spot: () => new SpotLight(),
  rectangle: () => new RectAreaLight(),
  disc: () => new RectAreaLight(),
  tube: () => new RectAreaLight(),
};

/** `profileSolidAngle` of each profile (sr), kept since it is an integral over the sphere. */
const solidAngles = new WeakMap<PhotometricProfile, number>();

const softened = new WeakSet<Scene>();

/** Reapplies the fields of a scene's lights whenever its `shadowSoftness` changes. */
function followSoftness(scene: Scene): void {
  if (softened.has(scene)) return;
  softened.add(scene);
  scene.onChange((change) => {
    if (change.kind !== 'settings' || change.field !== 'shadowSoftness') return;
    for (const light of scene.componentsOf(Light)) light.applyFields();
  });
}

/**
 * Lets a GameObject light the scene. It owns a three light below the object's object3D. Directional and spot lights,
 * rectangles and discs shine along the object's front (-Z); a tube lies along its X. Properties that three's lights
 * lack (the thesis's attenuations, extra colours and shapes) are in `three.userData.farol`, which @farol/renderer
 * reads.
 */
export class Light extends component(lightFields) {
  static override readonly typeName: string = 'Light';
  static override readonly icon: string = 'point';
  static override readonly unique: boolean = true;
  static override readonly help: string =
    'Ambient, hemisphere, directional, point or spot light, or one that shines from a rectangle, a disc or a tube.';

  static override readonly newObjects: readonly NewObject[] = newLights;

  private light: AnyLight | null = null;
  private substitute: Parameters<Light['setSubstitute']>[0] = null;
  /** Intensity of the three light before its group's dimmer. */
  private fullIntensity = 1;
  /** Name of the photometric profile that is being loaded; null for none. */
  private waitsFor: string | null = null;

  /** The three light; replaced when `type` changes. @throws Error when the component is on no GameObject */
  get three(): ThreeLight {
    if (!this.light) throw new Error('This Light is on no GameObject: add it with gameObject.addComponent.');
    return this.light;
  }

  /** World position of the light (m). */
  get position(): Vector3 {
    return this.gameObject.transform.worldPosition;
  }

  /** Unit vector in the world along which a directional or spot light shines. */
  get direction(): Vector3 {
    return this.gameObject.transform.front;
  }

  /** Linear colour: `diffuse`, or the colour of the temperature (luminance 1) if the colour is given by temperature. */
  get colour(): Vector3Tuple {
    return this.substitute?.colour ?? colourOfLight(this);
  }

  /** @internal Replaces the fields' colour and intensity, until called with null. Not an edit. */
  setSubstitute(light: { readonly colour: Vector3Tuple; readonly intensity: number } | null): void {
    this.substitute = light;
    if (this.light) this.applyFields();
  }

  /** Whether the light shines from a rectangle, a disc or a tube, of `width` and `height`. */
  get isArea(): boolean {
    return this.type === 'rectangle' || this.type === 'disc' || this.type === 'tube';
  }

  /** Lumens per candela of the profile's largest intensity (sr); null without a profile, and until it is loaded. */
  get profileSolidAngle(): number | null {
    const profile = this.takeProfile();
    if (!profile || profile.maximumIntensity === 0) return null;
    let angle = solidAngles.get(profile);
    if (angle === undefined) solidAngles.set(profile, (angle = profile.luminousFlux / profile.maximumIntensity));
    return angle;
  }

  /** Range of the light (m); Infinity without a limit. */
  get reach(): number {
    if (this.isArea) return this.areaRange || Infinity;
    if (this.type !== 'point' && this.type !== 'spot') return Infinity;
    if (this.attenuation === 'near-far') return this.far;
    return this.range > 0 ? this.range : Infinity;
  }

  /** Moves the light to `eye` and points it at `target`, both in world space; with one argument it only turns. */
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
    LightGroups.of(scene).add(this);
    LightGroups.of(scene).join(this, this.group);
    this.onActiveChanged();
    if (scene.settings.shadowSoftness !== 1 || this.profile !== null || this.group !== null) this.applyFields();
  }

  override onLeaveScene(scene: Scene): void {
    LightGroups.of(scene).remove(this);
    this.waitsFor = null;
  }

  override onActiveChanged(): void {
    if (this.light) this.light.visible = this.isDrawn;
  }

  override onFieldChanged(name: string): void {
    if (name === 'mode') this.onActiveChanged();
    else if (name === 'type') this.makeLight();
    else if (name === 'intensity') this.applyIntensity();
    else {
      if (name === 'group' && this.scene) LightGroups.of(this.scene).join(this, this.group);
      this.applyFields();
    }
  }

  /** @internal Called when the choice of lights that are shown alone (solo) has changed. */
  followSolo(): void {
    this.onActiveChanged();
  }

  /** @internal Called when the factors of the light's group change. */
  followGroup(tints: boolean): void {
    if (tints) this.applyFields();
    else this.three.intensity = this.fullIntensity * (this.master?.dimmer ?? 1);
  }

  /** @internal Writes all fields to the three light. */
  applyFields(): void {
    const { three } = this;
    const { substitute } = this;
    applyLightFields(this, three, this.scene?.settings.shadowSoftness);
    if (substitute) three.color.setRGB(...substitute.colour);
    if (three instanceof PointLight || three instanceof SpotLight)
      storeLightOptions(three, { profile: this.takeProfile()?.texture });
    this.applyIntensity();
    const { master } = this;
    if (master) tintLight(three, master.colour);
  }

  /** Writes the three light's intensity: the field's, adjusted by the profile and by the group's dimmer. */
  private applyIntensity(): void {
    const { three, substitute } = this;
    const isLocal = three instanceof PointLight || three instanceof SpotLight;
    const profile = isLocal && this.profileIntensity ? this.takeProfile() : null;
    this.fullIntensity = (substitute?.intensity ?? this.intensity) * (profile?.maximumIntensity ?? 1);
    three.intensity = this.fullIntensity * (this.master?.dimmer ?? 1);
  }

  private get master(): LightMaster | null {
    return this.group === null || !this.scene ? null : LightGroups.of(this.scene).masterOf(this.group);
  }

  /** Loaded photometric profile that the field names; null for none, and until loaded. */
  private takeProfile(): PhotometricProfile | null {
    const { scene, profile: name } = this;
    if (!scene || name === null) return null;
    if (scene.assets.isReady('profile', name)) return scene.assets.profile(name);
    if (this.waitsFor === name) return null;
    this.waitsFor = name;
    scene.assets.whenReady('profile', name, () => {
      if (this.waitsFor !== name) return;
      this.waitsFor = null;
      if (this.scene === scene && this.light) this.applyFields();
    });
    return null;
  }

  /** Whether the light is drawn: false while lightmaps contain it, or other lights are shown alone. */
  private get isDrawn(): boolean {
    const { scene } = this;
    if (!this.enabled || (this.mode === 'baked' && scene?.baked.hides(this.id))) return false;
    return !scene || !LightGroups.of(scene).isMuted(this);
  }

  private makeLight(): void {
    this.dropLight();
    const light = makers[this.type]();
    light.position.set(0, 0, 0);
    light.visible = this.isDrawn;
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
