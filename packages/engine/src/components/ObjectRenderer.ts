import { asset, boolean } from '@farol/editing/fields';
import { type BufferGeometry, type Material, Mesh } from 'three';
import { creaseAngleField, ownMaterialFields } from '../assets/materialFields';
import { component } from '../core/Component';
import type { FieldViews } from '../fields/FieldOwner';
import type { Scene } from '../core/Scene';
import { shapeOf } from '../core/ShapeSource';
import { fitBounds, objectSurfaceFields, ObjectSurface } from './ObjectSurface';
import { instanceGroupsOf } from './instances/InstanceGroups';

/** Fields that only choose flags of the mesh. */
const flags = new Set(['render', 'castShadow', 'receiveShadow']);

/**
 * Gives a GameObject a visible shape: a mesh and a material. The material is made from the fields, and shared by
 * renderers of equal values, or it is an asset (`material` or `shader`).
 */
export class ObjectRenderer extends component({
  mesh: asset('mesh', 'box', { help: 'Shape of the object.' }),
  render: boolean(true, { help: 'Whether the shape is drawn; its other components work on.', label: 'Visible' }),
  creaseAngle: creaseAngleField,
  castShadow: boolean(false, { help: 'Whether it casts shadows.', label: 'Cast shadow' }),
  receiveShadow: boolean(false, { help: 'Whether shadows fall on it.', label: 'Receive shadow' }),
  instanced: boolean(false, {
    help: 'Draw it in one call with all others of the same mesh and material: for many small things. Colours may differ.',
  }),
  shader: asset('shader', null, {
    help: "A shader of the library, in place of three's materials.",
    // shaders come only from scripts and imported models, not from the inspector
    deprecated: true,
  }),
  material: asset('material', null, {
    help: 'A material of the library, such as one of an imported model.',
    visibleWhen: { field: 'shader', equals: [null] },
  }),
  ...ownMaterialFields,
  ...objectSurfaceFields,
  surface: { ...objectSurfaceFields.surface, visibleWhen: { field: 'shader', equals: [null] } },
}) {
  static override readonly typeName: string = 'ObjectRenderer';
  static override readonly icon: string = 'mesh';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'A mesh with a material.';

  private readonly worn = new ObjectSurface(
    this,
    ObjectRenderer.fields,
    () => this.refreshMaterial(),
    () => this.mesh3D && fitBounds(this.mesh3D),
  );
  private mesh3D: Mesh | null = null;
  private geometryInUse: BufferGeometry | null = null;
  private ownMaterial: Material | null = null;
  private inGroup = false;
  /** Name of the library material whose changes are listened to. */
  private watched: string | null = null;
  /** Name of the mesh asset whose geometry is drawn; null for another geometry. */
  private meshName: string | null = null;
  /** Cancels the computation of normals that the component waits for; null when it does not wait. */
  private waiting: AbortController | null = null;

  /**
   * The three mesh below the GameObject's object3D; null outside a scene, before its asset is loaded, or when
   * instanced.
   */
  get three(): Mesh | null {
    return this.mesh3D;
  }

  /** The geometry that is drawn, with normals; null as long as there is none. */
  get geometry(): BufferGeometry | null {
    return this.geometryInUse;
  }

  /** @internal */
  override get fieldViews(): FieldViews | undefined {
    return this.worn?.views;
  }

  override onEnterScene(): void {
    this.refreshGeometry();
  }

  override onLeaveScene(scene: Scene): void {
    this.clear(scene);
  }

  override onFieldChanged(name: string): void {
    if (!this.scene || this.worn.fieldChanged(name)) return;
    if (name === 'mesh' || name === 'creaseAngle') this.refreshGeometry();
    else if (flags.has(name) && !this.inGroup) this.applyFlags();
    else this.refreshMaterial();
  }

  override endSimulation(): void {
    super.endSimulation();
    if (this.scene) this.worn.simulationEnded();
  }

  override onActiveChanged(): void {
    this.applyFlags();
  }

  /** Applies the geometry again: a component that shapes the object has changed, was added or removed. @internal */
  shapeChanged(): void {
    this.refreshGeometry();
  }

  /** @internal */
  materialReplaced(): void {
    this.refreshMaterial();
  }

  /** Applies the geometry that the fields name, now or once its asset is loaded and has normals. */
  private refreshGeometry(): void {
    const { scene, mesh } = this;
    if (!scene) return;
    this.waiting?.abort();
    this.waiting = null;
    const own = shapeOf(this.gameObject.components);
    if (own) {
      this.show(scene, own, null);
      return;
    }
    if (mesh !== null && !scene.assets.isReady('mesh', mesh)) {
      this.clear(scene);
      scene.assets.whenReady('mesh', mesh, () => {
        if (this.scene === scene && this.mesh === mesh) this.refreshGeometry();
      });
      return;
    }
    if (mesh !== null && !scene.assets.isMeshReady(mesh, this.creaseAngle)) {
      // for another crease angle of the same mesh, the old geometry is drawn until the new one is ready
      if (mesh !== this.meshName) this.clear(scene);
      const waiting = (this.waiting = new AbortController());
      const again = (): void => {
        if (this.waiting === waiting) this.refreshGeometry();
      };
      scene.assets.prepareMesh(mesh, this.creaseAngle, waiting.signal).then(again, () => {});
      return;
    }
    this.show(scene, mesh === null ? null : scene.assets.mesh(mesh, this.creaseAngle), mesh);
  }

  /** Draws a geometry. @param mesh - name of its mesh in the library; null for another geometry */
  private show(scene: Scene, geometry: BufferGeometry | null, mesh: string | null): void {
    if (geometry === this.geometryInUse && geometry) return;
    if (geometry) scene.assets.uses.acquire(geometry);
    this.clear(scene);
    this.geometryInUse = geometry;
    this.meshName = mesh;
    this.refreshMaterial();
  }

  /** Applies the material of the fields, and creates or changes the drawn mesh. */
  private refreshMaterial(): void {
    const { scene, geometryInUse: geometry } = this;
    if (!scene || !geometry) return;
    if (this.inGroup) instanceGroupsOf(scene).remove(this);
    this.inGroup = false;
    const source = this.takeMaterial(scene);
    let material = source;
    this.worn.dress(scene, (wear) => (material = wear(source)));
    if (this.instanced) {
      this.dropMesh(scene);
      this.inGroup = true;
      instanceGroupsOf(scene).add(this, geometry, material);
    } else if (this.mesh3D) {
      this.mesh3D.material = material;
    } else {
      this.mesh3D = new Mesh(geometry, material);
      this.mesh3D.name = this.gameObject.name;
      this.gameObject.object3D.add(this.mesh3D);
    }
    this.applyFlags();
  }

  private takeMaterial(scene: Scene): Material {
    const { assets } = scene;
    const given = this.givenMaterial(scene);
    this.watch(scene, this.shader === null ? this.material : null);
    if (given) {
      this.releaseMaterial(scene);
      return given;
    }
    const values = this.instanced ? Object.assign(this.materialValues(), { colour: [1, 1, 1] as const }) : this;
    this.ownMaterial = this.ownMaterial
      ? assets.materials.change(this.ownMaterial, values)
      : assets.materials.acquire(values);
    return this.ownMaterial;
  }

  /** Library material that the fields name; null for none, and until loaded. */
  private givenMaterial(scene: Scene): Material | null {
    const [type, name] =
      this.shader !== null ? (['shader', this.shader] as const) : (['material', this.material] as const);
    if (name === null) return null;
    if (scene.assets.isReady(type, name)) return scene.assets[type](name);
    scene.assets.whenReady(type, name, () => {
      if (this.scene === scene && this[type] === name) this.refreshMaterial();
    });
    return null;
  }

  private materialValues(): Pick<this, keyof typeof ownMaterialFields> {
    const names = Object.keys(ownMaterialFields);
    return Object.fromEntries(names.map((name) => [name, this.get(name)])) as Pick<
      this,
      keyof typeof ownMaterialFields
    >;
  }

  private applyFlags(): void {
    const mesh = this.mesh3D;
    if (!mesh) return;
    mesh.visible = this.enabled && this.render;
    mesh.castShadow = this.castShadow;
    mesh.receiveShadow = this.receiveShadow;
    this.scene?.baked.dress(this.id, mesh);
    fitBounds(mesh);
  }

  private dropMesh(scene: Scene): void {
    if (!this.mesh3D) return;
    scene.baked.undress(this.mesh3D);
    this.mesh3D.removeFromParent();
    this.mesh3D = null;
  }

  private watch(scene: Scene, material: string | null): void {
    if (material === this.watched) return;
    if (this.watched !== null) scene.assets.removeMaterialUser(this.watched, this);
    if (material !== null) scene.assets.addMaterialUser(material, this);
    this.watched = material;
  }

  private releaseMaterial(scene: Scene): void {
    if (this.ownMaterial) scene.assets.materials.release(this.ownMaterial);
    this.ownMaterial = null;
  }

  private clear(scene: Scene): void {
    this.waiting?.abort();
    this.waiting = null;
    this.meshName = null;
    if (this.inGroup) instanceGroupsOf(scene).remove(this);
    this.inGroup = false;
    this.dropMesh(scene);
    this.worn.end(scene);
    this.releaseMaterial(scene);
    this.watch(scene, null);
    if (this.geometryInUse) scene.assets.uses.release(this.geometryInUse);
    this.geometryInUse = null;
  }
}
