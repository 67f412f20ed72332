import { t } from '@farol/editing';
import {
  Animation,
  Animator,
  Camera,
  type GameObject,
  Light,
  type Model,
  ModelRenderer,
  ObjectRenderer,
  ParticleEmitter,
  type Scene,
  Transform,
} from '@farol/engine';
import { hasReadableVertices } from '@farol/renderer/vertex-data';
import type { PhotometricProfile } from '@farol/renderer/light-profiles';
import {
  type AnimationClip,
  type BufferGeometry,
  type Light as ThreeLight,
  type Material,
  Mesh,
  type MeshBasicMaterial,
  Object3D,
  type MeshStandardMaterial,
  PointLight,
  Scene as ThreeScene,
  SpotLight,
  type WebGLRenderer,
} from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';
import { breathe } from './breathe';
import { gltfAnimations } from './gltfAnimations';
import { gltfGeometry } from './gltfGeometry';
import { gltfLight, gltfProfileLight, gltfShapeLight, whatIsLost, whatProfileLoses } from './gltfLight';
import { GltfMaterials } from './GltfMaterials';
import type { ProfileLight } from './GltfProfiles';
import { LeftOut } from './LeftOut';

type Drawn = Mesh<BufferGeometry, Material | Material[]>;

/** A copy of a scene reduced to what glTF supports. Vertex arrays are shared with the original, everything else is copied. */
export class GltfScene {
  readonly three = new ThreeScene();
  readonly leftOut = new LeftOut();
  /** Clips with tracks that refer to nodes of `three` by uuid. */
  animations: readonly AnimationClip[] = [];
  /** Nodes with a light that has a photometric profile. */
  readonly profiles: ReadonlyMap<Object3D, ProfileLight>;
  private readonly profileLights = new Map<Object3D, ProfileLight>();
  private readonly materials: GltfMaterials;
  private readonly geometries = new Map<string, BufferGeometry | null>();
  private readonly skinned: Object3D[] = [];
  /** Exported node of each object, and of each drawn node of a model. */
  private readonly nodes = new Map<GameObject | Object3D, Object3D>();
  private readonly endings: (() => void)[] = [];

  private constructor(
    private readonly scene: Scene,
    webgl: WebGLRenderer,
  ) {
    this.materials = new GltfMaterials(webgl, this.leftOut);
    this.three.name = scene.name;
    this.profiles = this.profileLights;
  }

  /**
   * @param webgl - for reading back compressed textures @throws Error naming the object whose texture cannot be read
   */
  static async make(scene: Scene, webgl: WebGLRenderer): Promise<GltfScene> {
    const made = new GltfScene(scene, webgl);
    // glTF has no lightmaps: meshes are exported without them
    const showAgain = scene.baked.suspend();
    try {
      for (const root of scene.roots) await made.addObject(root, made.three);
      made.animations = gltfAnimations(scene, made.nodes, made.leftOut);
      made.freeSkins();
      made.noteSurroundings();
      return made;
    } catch (error) {
      made.dispose();
      throw error;
    } finally {
      showAgain();
    }
  }

  dispose(): void {
    for (const end of this.endings) end();
    this.materials.dispose();
  }

  private async addObject(object: GameObject, parent: Object3D): Promise<void> {
    if (!object.active) {
      this.leftOut.add(t('Hidden objects are left out'), object);
      return;
    }
    await breathe();
    const parts: Object3D[] = [];
    for (const component of object.components) {
      if (!component.enabled || component instanceof Transform) continue;
      let part: Object3D | null = null;
      if (component instanceof ObjectRenderer) part = await this.meshOf(component);
      else if (component instanceof ModelRenderer) part = await this.modelOf(component);
      else if (component instanceof Light) part = this.lightOf(component);
      else if (component instanceof Camera) part = component.three.clone();
      else if (component instanceof ParticleEmitter)
        this.leftOut.add(t('Particles and the light that they give are left out'), component, object.name);
      else if (!(component instanceof Animation || component instanceof Animator))
        this.leftOut.add(
          t('Components that glTF does not know are left out: {typeName}', { typeName: component.typeName }),
          component,
        );
      if (part) parts.push(part);
    }
    const isProfileLight = parts.length === 1 && this.profiles.has(parts[0].children[0]);
    const isAlone = parts.length === 1 && (parts[0].children.length === 0 || isProfileLight);
    const node = isAlone ? parts[0] : new Object3D();
    if (!isAlone && parts.length > 0) node.add(...parts);
    node.name = object.name;
    this.nodes.set(object, node);
    const { position, quaternion, scale } = object.object3D;
    node.position.copy(position);
    node.quaternion.copy(quaternion);
    node.scale.copy(scale);
    parent.add(node);
    for (const child of object.children) await this.addObject(child, node);
  }

  private async meshOf(shape: ObjectRenderer): Promise<Mesh | null> {
    const { geometry, mesh, gameObject } = shape;
    if (mesh === null) return null;
    if (!shape.render) this.leftOut.add(t('Hidden objects are left out'), gameObject);
    else if (!geometry) this.leftOut.add(t('Meshes that are not loaded are left out'), shape);
    if (!shape.render || !geometry) return null;
    const drawn = new Mesh(geometry, this.materialOf(shape));
    drawn.name = mesh;
    const maps = [shape.map, shape.normalMap].filter((name) => name !== null);
    const user = maps.length > 0 ? `'${gameObject.name}' (${maps.join(', ')})` : `'${gameObject.name}'`;
    return (await this.convert(drawn, user, gameObject.name)) ? drawn : null;
  }

  private materialOf(shape: ObjectRenderer): Material {
    if (shape.three) return shape.three.material as Material;
    const { materials } = this.scene.assets;
    if (shape.shader !== null) return this.scene.assets.shader(shape.shader);
    if (shape.surface !== null) this.leftOut.addSurface(shape.surface, shape.gameObject.name);
    if (shape.material !== null) return this.scene.assets.material(shape.material);
    // an instanced object has a colour but no material of its own
    const material = materials.acquire(shape);
    this.endings.push(() => materials.release(material));
    return material;
  }

  private async modelOf(model: ModelRenderer): Promise<Object3D | null> {
    const { three, gameObject } = model;
    if (model.model === null) return null;
    if (!three) {
      this.leftOut.add(t('Models that are not loaded are left out'), model);
      return null;
    }
    const copy = clone(three);
    const parts: Object3D[] = [];
    const sources: Object3D[] = [];
    copy.traverse((part) => parts.push(part));
    three.traverse((part) => sources.push(part));
    for (const [i, part] of parts.entries()) {
      await breathe();
      part.userData = {};
      this.nodes.set(sources[i], part);
      if ('isLight' in part) {
        const light = this.replaceLight(part as never, sources[i], model.drawnModel);
        if (light) this.nodes.set(sources[i], light);
        else this.nodes.delete(sources[i]);
      } else if ('geometry' in part && !(await this.convert(part as Drawn, `'${gameObject.name}'`, gameObject.name))) {
        part.removeFromParent();
        this.nodes.delete(sources[i]);
      }
      if ('isSkinnedMesh' in part) this.skinned.push(part);
    }
    return copy;
  }

  private replaceLight(
    source: Parameters<typeof gltfLight>[0],
    original: Object3D,
    model: Model | null,
  ): Object3D | null {
    const { parent } = source;
    const profile = model?.profileOf(original);
    const copy = profile ? this.profileLightOf(source, profile, null) : gltfLight(source, null);
    if (!copy) this.leftOut.add(t('Lights from all sides are left out'), source);
    else {
      copy.name = source.name;
      copy.position.copy(source.position);
      copy.quaternion.copy(source.quaternion);
      parent?.add(copy);
    }
    source.removeFromParent();
    return copy;
  }

  private lightOf(light: Light): Object3D | null {
    if (light.isArea) {
      this.leftOut.add(t('Lights with a shape shine in Farol alone: glTF has none'), light);
      return gltfShapeLight(light);
    }
    const { assets } = this.scene;
    const { profile: name, three } = light;
    const hasProfile = three instanceof PointLight || three instanceof SpotLight ? name !== null : false;
    const profile = hasProfile && assets.isReady('profile', name!) ? assets.profile(name!) : null;
    if (hasProfile && !profile) this.leftOut.add(t('Profiles of lights that are not loaded are left out'), light);
    const copy = profile ? this.profileLightOf(three, profile, light) : gltfLight(three, light);
    const lost = copy ? whatIsLost(light) : t('Lights from all sides are left out');
    if (lost) this.leftOut.add(lost, light);
    return copy;
  }

  /** A parent for the light's node, which is rotated as EXT_lights_ies requires. */
  private profileLightOf(source: ThreeLight, profile: PhotometricProfile, light: Light | null): Object3D {
    const made = gltfProfileLight(source as PointLight | SpotLight, profile, light);
    this.profileLights.set(made.node, made.light);
    const lost = whatProfileLoses(source);
    if (lost) this.leftOut.add(lost, source);
    return new Object3D().add(made.node);
  }

  /** Converts a mesh's geometry and materials to glTF. @returns whether anything is left of it */
  private async convert(drawn: Drawn, user: string, object: string): Promise<boolean> {
    if (!hasReadableVertices(drawn.geometry)) {
      this.leftOut.add(t('Meshes whose arrays were freed are left out'), object);
      return false;
    }
    const sources = Array.isArray(drawn.material) ? drawn.material : [drawn.material];
    const { attributes } = drawn.geometry;
    const use = { user, object, hasUV: 'uv' in attributes, hasTangents: 'tangent' in attributes };
    const materials = await Promise.all(sources.map((source) => this.materials.convert(source, use)));
    const glTFMaterials = materials as (MeshStandardMaterial | MeshBasicMaterial)[];
    const isTriangles = 'isMesh' in drawn;
    const look = {
      vertexColours: glTFMaterials.some(({ vertexColors }) => vertexColors),
      flat: glTFMaterials.some((material) => 'flatShading' in material && material.flatShading),
      tangents: glTFMaterials.some((material) => 'normalMap' in material && material.normalMap),
      edges: isTriangles && glTFMaterials.some(({ wireframe }) => wireframe),
    };
    const geometry = this.geometryOf(drawn.geometry, look);
    if (!geometry) return false;
    drawn.geometry = geometry;
    drawn.material = Array.isArray(drawn.material) ? materials : materials[0];
    return true;
  }

  private geometryOf(source: BufferGeometry, look: Parameters<typeof gltfGeometry>[1]): BufferGeometry | null {
    const key = `${source.uuid} ${Object.values(look).join()}`;
    let made = this.geometries.get(key);
    if (made === undefined) this.geometries.set(key, (made = gltfGeometry(source, look)));
    return made;
  }

  /** Moves skinned meshes to the top, since only joints define their position. @see glTF 2.0, 3.7.3.3 */
  private freeSkins(): void {
    for (const mesh of this.skinned) {
      this.three.add(mesh);
      mesh.position.set(0, 0, 0);
      mesh.quaternion.identity();
      mesh.scale.set(1, 1, 1);
    }
  }

  private noteSurroundings(): void {
    const { settings } = this.scene;
    const isBlack = settings.backgroundColour.every((channel) => channel === 0);
    if (settings.bakedLight !== null) this.leftOut.add(t('Baked light is left out: its lights shine themselves'));
    if (settings.environment !== null) this.leftOut.add(t('The environment is left out'));
    if (!isBlack || settings.background !== 'colour') this.leftOut.add(t('The background is left out'));
    if (settings.fog !== 'none') this.leftOut.add(t('Fog is left out'));
  }
}
