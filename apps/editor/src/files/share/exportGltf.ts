import { Camera, type GameObject, Light, ModelRenderer, ObjectRenderer, type Scene } from '@farol/engine';
import {
  Color,
  DirectionalLight,
  type Light as ThreeLight,
  type Material,
  Mesh,
  MeshBasicMaterial,
  type MeshPhongMaterial,
  MeshStandardMaterial,
  Object3D,
  PointLight,
  Scene as ThreeScene,
  SpotLight,
} from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';

/** A glTF, and what it could not take along. */
export interface ExportedGltf {
  readonly blob: Blob;
  /** One sentence each. */
  readonly leftOut: readonly string[];
}

const counted = (count: number, what: string): string => `${count} ${what}${count === 1 ? '' : 's'}`;

class GltfScene {
  readonly three = new ThreeScene();
  readonly shaders = new Set<string>();
  readonly lights = new Set<string>();
  private readonly materials = new Map<Material, Material>();
  private readonly made: Material[] = [];

  constructor(private readonly scene: Scene) {
    this.three.name = scene.name;
    for (const root of scene.roots) this.three.add(this.convert(root));
  }

  dispose(): void {
    for (const material of this.made) material.dispose();
  }

  private convert(object: GameObject): Object3D {
    const node = new Object3D();
    node.name = object.name;
    const { position, quaternion, scale } = object.object3D;
    node.position.copy(position);
    node.quaternion.copy(quaternion);
    node.scale.copy(scale);
    node.visible = object.active;
    for (const component of object.components) {
      if (!component.enabled) continue;
      if (component instanceof ObjectRenderer) this.addMesh(node, component);
      else if (component instanceof ModelRenderer && component.three) node.add(clone(component.three));
      else if (component instanceof Light) this.addLight(node, component);
      else if (component instanceof Camera) node.add(component.three.clone());
    }
    for (const child of object.children) node.add(this.convert(child));
    return node;
  }

  private addMesh(node: Object3D, shape: ObjectRenderer): void {
    const { geometry, three, mesh } = shape;
    if (!geometry || mesh === null) return;
    const child = new Mesh(
      geometry,
      three ? this.toStandard(three.material as Material) : this.instanceMaterial(shape),
    );
    child.name = mesh;
    node.add(child);
  }

  /** What is drawn as one of many instances has no material of its own. */
  private instanceMaterial({ material, colour, roughness, metalness }: ObjectRenderer): Material {
    if (material !== null) return this.toStandard(this.scene.assets.material(material));
    const made = new MeshStandardMaterial({ color: new Color().setRGB(...colour), roughness, metalness });
    this.made.push(made);
    return made;
  }

  /** What glTF has: metal and roughness, or unlit. */
  private toStandard(source: Material): Material {
    const known = this.materials.get(source);
    if (known) return known;
    let material = source;
    if ('isShaderMaterial' in source) {
      this.shaders.add(source.name || 'unnamed');
      material = new MeshBasicMaterial({ color: 0x808080 });
    } else if (!(source instanceof MeshStandardMaterial) && !(source instanceof MeshBasicMaterial)) {
      const { color, map, normalMap, emissive, emissiveIntensity, shininess } = source as MeshPhongMaterial;
      const { transparent, opacity, alphaTest, side, vertexColors, name } = source;
      // Blinn-Phong's exponent n as roughness: alpha = sqrt(2 / (n + 2)), roughness = sqrt(alpha) @see Walter 2007
      const roughness = shininess === undefined ? 1 : (2 / (shininess + 2)) ** 0.25;
      const values = { color, map, normalMap, emissive, emissiveIntensity, roughness, metalness: 0 };
      material = new MeshStandardMaterial({ ...values, transparent, opacity, alphaTest, side, vertexColors, name });
    }
    this.materials.set(source, material);
    if (material !== source) this.made.push(material);
    return material;
  }

  private addLight(node: Object3D, light: Light): void {
    const source: ThreeLight = light.three;
    let copy: DirectionalLight | PointLight | SpotLight;
    if (source instanceof SpotLight) {
      copy = new SpotLight(source.color, source.intensity, source.distance, source.angle, source.penumbra);
    } else if (source instanceof PointLight) copy = new PointLight(source.color, source.intensity, source.distance);
    else if (source instanceof DirectionalLight) copy = new DirectionalLight(source.color, source.intensity);
    else {
      this.lights.add(light.gameObject.name);
      return;
    }
    if (!(copy instanceof PointLight)) {
      copy.add(copy.target);
      copy.target.position.set(0, 0, -1);
      copy.position.set(0, 0, 0);
    }
    copy.name = light.gameObject.name;
    node.add(copy);
  }
}

/** The scene as a GLB: tree, meshes, materials, models, cameras and the lights that glTF knows. @see glTF 2.0, KHR_lights_punctual */
export async function exportGltf(scene: Scene): Promise<ExportedGltf> {
  const { GLTFExporter } = await import('three/addons/exporters/GLTFExporter.js');
  const source = new GltfScene(scene);
  const animations = scene.assets.list('model').flatMap((name) => {
    return scene.assets.isReady('model', name) ? scene.assets.model(name).animations : [];
  });
  try {
    const options = { binary: true, onlyVisible: false, animations: [] as typeof animations };
    const glb = (await new GLTFExporter().parseAsync(source.three, options)) as ArrayBuffer;
    const { shaders, lights } = source;
    const leftOut = [
      ...(shaders.size > 0 ? [`${counted(shaders.size, 'shader')} became grey: glTF has none.`] : []),
      ...(lights.size > 0 ? [`${counted(lights.size, 'light')} from all sides left out: glTF has none.`] : []),
      ...(animations.length > 0 ? ['Animations are left out.'] : []),
    ];
    return { blob: new Blob([glb], { type: 'model/gltf-binary' }), leftOut };
  } finally {
    source.dispose();
  }
}
