import { Color, EquirectangularReflectionMapping, Fog, FogExp2, type Scene as ThreeScene, type Texture } from 'three';
import type { AssetLibrary } from '../assets/AssetLibrary';
import type { FieldValue, ValuesOf } from '../fields/Field';
import { defineFieldProperties } from '../fields/defineFieldProperties';
import { type AssetNames, BaseFieldOwner } from '../fields/FieldOwner';
import { asset, choice, colour, number } from '../fields/fields';

const linearFog = { visibleWhen: { field: 'fog', equals: ['linear'] } };

export const sceneFields = {
  background: choice('colour', ['colour', 'environment'], { help: 'What is seen where there is no object.' }),
  backgroundColour: colour([0.02, 0.025, 0.035], { help: 'Colour behind the objects.', label: 'Background colour' }),
  environment: asset('texture', null, {
    help: 'Equirectangular texture that lights every standard and physical material from all sides.',
  }),
  environmentIntensity: number(1, {
    min: 0,
    step: 0.05,
    help: 'Factor of the light that comes from the environment.',
    label: 'Environment intensity',
  }),
  fog: choice('none', ['none', 'linear', 'exponential'], { help: 'Fog that fades objects into a colour.' }),
  fogColour: colour([0.5, 0.55, 0.6], {
    help: 'Colour of the fog.',
    label: 'Fog colour',
    visibleWhen: { field: 'fog', equals: ['linear', 'exponential'] },
  }),
  fogNear: number(10, { unit: 'm', min: 0, help: 'Distance where the fog begins.', label: 'Fog near', ...linearFog }),
  fogFar: number(100, { unit: 'm', min: 0, help: 'Distance of full fog.', label: 'Fog far', ...linearFog }),
  fogDensity: number(0.02, {
    unit: '1/m',
    min: 0,
    step: 0.001,
    help: 'Growth of exponential fog with distance.',
    label: 'Fog density',
    visibleWhen: { field: 'fog', equals: ['exponential'] },
  }),
};

// oxlint-disable-next-line typescript/no-unsafe-declaration-merging -- the properties are made from the table
export interface SceneSettings extends ValuesOf<typeof sceneFields> {}

/** What belongs to a scene as a whole: background, environment, fog. Writes them to its three scene. */
export class SceneSettings extends BaseFieldOwner {
  static readonly fields = sceneFields;

  private environmentTexture: Texture | null = null;

  /** @param changed - called after a setting got another value; `before` is the value until then */
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

  protected override get assetNames(): AssetNames {
    return this.assets;
  }

  protected override fieldChanged(name: string, before: FieldValue): void {
    this.apply();
    this.changed(name, before);
  }

  /** Lets go of the environment. */
  dispose(): void {
    this.useTexture(null);
  }

  /** Writes every setting to the three scene. */
  private apply(): void {
    const { three } = this;
    this.applyEnvironment(three);
    three.environmentIntensity = this.environmentIntensity;
    const useTexture = this.background === 'environment' && this.environmentTexture !== null;
    three.background = useTexture ? this.environmentTexture : new Color().setRGB(...this.backgroundColour);
    three.backgroundIntensity = this.environmentIntensity;
    const fogColour = new Color().setRGB(...this.fogColour);
    if (this.fog === 'linear') three.fog = new Fog(fogColour, this.fogNear, this.fogFar);
    else if (this.fog === 'exponential') three.fog = new FogExp2(fogColour, this.fogDensity);
    else three.fog = null;
  }

  private applyEnvironment(three: ThreeScene): void {
    const name = this.environment;
    const { assets } = this;
    if (name === null) this.useTexture(null);
    else if (assets.isReady('texture', name)) this.useTexture(assets.texture(name));
    else assets.whenReady('texture', name, () => this.environment === name && this.apply());
    three.environment = this.environmentTexture;
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
