import type { Object3D } from 'three';
import type { BakedLight } from '../../assets/bake/BakedLight';
import { bakeCode } from './bakeCode';
import type { Scene } from '../Scene';
import type { ShownBake } from './ShownBake';

/** Types of components that baked light affects. */
const TYPES = ['Light', 'ObjectRenderer', 'ModelRenderer'];

/** The baked light of a scene (setting `bakedLight`), displayed by late code that is fetched with the asset. */
export class SceneBake {
  private appliedBake: ShownBake | null = null;
  private light: BakedLight | null = null;
  private suspensions = 0;

  constructor(private readonly scene: Scene) {}

  /** Whether the scene is drawn with its baked light. */
  get isShown(): boolean {
    return this.appliedBake !== null;
  }

  /** Hides the baked light during a new bake. @returns a function that shows it again */
  suspend(): () => void {
    this.suspensions++;
    this.update();
    return () => {
      this.suspensions--;
      this.update();
    };
  }

  /** Shows the baked light that the setting names, once its asset and the code are loaded. */
  update(): void {
    const light = this.bakeOfSettings();
    if (light === this.light) return;
    this.dispose();
    this.light = light;
    this.appliedBake = light && new bakeCode.code!.ShownBake(this.scene, light.data);
    for (const type of TYPES) for (const component of this.scene.componentsOf(type)) component.onActiveChanged();
  }

  /** Baked light that the scene's setting names; null while not loaded or unset. */
  private bakeOfSettings(): BakedLight | null {
    const { settings, assets } = this.scene;
    const name = this.suspensions > 0 ? null : settings.bakedLight;
    if (name === null) return null;
    const again = (): void => void (this.light === null && settings.bakedLight === name && this.update());
    if (bakeCode.codeOr(again) === null) return null;
    if (assets.isReady('bake', name)) return assets.bake(name);
    assets.whenReady('bake', name, again);
    return null;
  }

  /** @internal Whether a light is baked, and so not drawn. @param light - id of the component */
  hides(light: string): boolean {
    return this.appliedBake !== null && this.appliedBake.hides(light);
  }

  /** @internal Gives the meshes of a component their lightmaps. @param component - its id */
  dress(component: string, root: Object3D): void {
    this.appliedBake?.dress(component, root);
  }

  /** @internal Restores the materials and geometries of meshes that leave the scene. */
  undress(root: Object3D): void {
    this.appliedBake?.undress(root);
  }

  dispose(): void {
    this.appliedBake?.end();
    this.appliedBake = this.light = null;
  }
}
