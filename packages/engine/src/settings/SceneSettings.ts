import { type FieldValue, type ValuesOf, vector3 } from '@farol/editing/fields';
import { Color, EquirectangularReflectionMapping, Fog, FogExp2, type Scene as ThreeScene, type Texture } from 'three';
import type { AssetLibrary } from '../assets/AssetLibrary';
import { defineFieldProperties } from '../fields/defineFieldProperties';
import { type AssetNames, FieldOwner } from '../fields/FieldOwner';
import { bakeFields } from './bakeFields';
import { fogFields, pictureFields, skyFields } from './pictureFields';
import type { DaySky } from './sky/daySky';
import type { Sky } from './sky/makeSky';
import { SkySource } from './sky/SkySource';

const physicsFields = {
  gravity: vector3([0, -9.81, 0], {
    unit: 'm/s²',
    step: 0.1,
    help: 'Acceleration of every dynamic body while the scene plays.',
  }),
};

export const sceneFields = { ...pictureFields, ...physicsFields, ...bakeFields };

// oxlint-disable-next-line typescript/no-unsafe-declaration-merging -- the properties are made from the table
export interface SceneSettings extends ValuesOf<typeof sceneFields> {}

/**
 * Settings of a whole scene: background, light, picture and gravity. Background, environment and fog are written to its
 * three scene; a `PictureRenderer` reads the rest.
 */
export class SceneSettings extends FieldOwner {
  static readonly fields = sceneFields;

  private environmentTexture: Texture | null = null;
  private readonly skySource = new SkySource(() => this.apply());
  private day: DaySky | null = null;
  private count = 0;

  /** @param changed - called after a setting changed; `before` is its previous value */
  constructor(
    private readonly three: ThreeScene,
    private readonly assets: AssetLibrary,
    private readonly changed: (field: string, before: FieldValue) => void,
  ) {
    super();
    this.apply();
  }

  override get ownerName(): string {
    return 'Scene';
  }

  /** Grows by one with each change. */
  get revision(): number {
    return this.count;
  }

  /**
   * Resolves when the sky requested last is painted; null before the first wait.
   * @throws Error (as a rejection) when its code cannot be fetched
   */
  get skyReady(): Promise<void> | null {
    return this.skySource.ready;
  }

  /** @internal Shows a day's sky in place of the one in the settings; null restores that. Not an edit. */
  showDay(day: DaySky | null): void {
    this.day = day;
    this.apply();
  }

  protected override get assetNames(): AssetNames {
    return this.assets;
  }

  protected override fieldChanged(name: string, before: FieldValue): void {
    this.count++;
    if (Object.hasOwn(skyFields, name) || Object.hasOwn(fogFields, name)) this.apply();
    this.changed(name, before);
  }

  /** Releases the environment texture. */
  dispose(): void {
    this.useTexture(null);
    this.skySource.dispose();
  }

  /** Writes sky and fog to the three scene. */
  private apply(): void {
    const { three } = this;
    this.count++;
    const { day } = this;
    const sky = this.skySource.of(this, day);
    this.applyEnvironment(three, sky);
    const seen = sky ? sky.texture : this.background === 'environment' ? this.environmentTexture : null;
    three.background = seen ?? new Color().setRGB(...this.backgroundColour);
    const { illuminance = null } = day ?? {};
    const brightness = sky?.irradiance && illuminance !== null ? illuminance / sky.irradiance : 1;
    three.environmentIntensity = this.environmentIntensity * brightness;
    three.backgroundIntensity = three.environmentIntensity * this.backgroundIntensity;
    three.backgroundBlurriness = this.background === 'gradient' ? 0 : this.backgroundBlur;
    three.backgroundRotation.y = three.environmentRotation.y = day ? 0 : this.backgroundRotation;
    this.applyFog(three, sky);
  }

  private applyFog(three: ThreeScene, sky: Sky | null): void {
    const fogColour = new Color().setRGB(...this.fogColour);
    if (this.fogFromSky && sky) fogColour.setRGB(...sky.horizon).multiplyScalar(three.backgroundIntensity);
    else if (this.fogFromSky) fogColour.setRGB(...this.backgroundColour);
    if (this.fog === 'linear') three.fog = new Fog(fogColour, this.fogNear, this.fogFar);
    else if (this.fog === 'exponential') three.fog = new FogExp2(fogColour, this.fogDensity);
    else three.fog = null;
  }

  private applyEnvironment(three: ThreeScene, sky: Sky | null): void {
    const isSky = this.day !== null || this.background === 'sky' || this.background === 'gradient';
    const name = isSky ? null : this.environment;
    const { assets } = this;
    if (name === null) this.useTexture(null);
    else if (assets.isReady('texture', name)) this.useTexture(assets.texture(name));
    else assets.whenReady('texture', name, () => this.environment === name && this.apply());
    three.environment = sky && (this.day !== null || this.skyLight) ? sky.texture : this.environmentTexture;
  }

  private useTexture(texture: Texture | null): void {
    const before = this.environmentTexture;
    if (texture === before) return;
    if (texture) {
      texture.mapping = EquirectangularReflectionMapping;
      this.assets.uses.acquire(texture);
    }
    this.environmentTexture = texture;
    if (before) this.assets.uses.release(before);
  }
}

defineFieldProperties(SceneSettings.prototype, sceneFields);
