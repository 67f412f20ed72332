import { checkFieldValue, type FieldValue } from '@farol/editing/fields';
import {
  type DirectionalLight,
  type InstancedMesh,
  type Light as ThreeLight,
  type Material,
  Matrix4,
  type Mesh,
  type Object3D,
  type OrthographicCamera,
  type PerspectiveCamera,
  Quaternion,
  type RectAreaLight,
  type SpotLight,
  type Texture,
  Vector3,
} from 'three';
import type { FarolLightData } from '@farol/renderer/light-options';
import type { AssetLibrary } from '../assets/AssetLibrary';
import { materialValuesOf } from '../assets/materialValuesOf';
import type { Model } from '../assets/Model';
import { commonAncestor, partsText } from '../assets/modelNodes';
import { modelParts } from '../assets/modelParts';
import { GameObject } from '../core/GameObject';
import { Camera } from './Camera';
import { type KeptFor, type KeptPart, keptTogether } from './keptTogether';
import { Light } from './Light';
import { ModelRenderer } from './ModelRenderer';
import { objectLike } from './importModel';
import { ObjectRenderer } from './ObjectRenderer';

type Values = Readonly<Record<string, FieldValue>>;

/** Result of unpacking a model into GameObjects. */
export interface ObjectsOfModel {
  /** Objects for the model's top nodes, not yet in any scene. */
  readonly objects: readonly GameObject[];
  /** Materials that the library does not have yet, for `AssetLibrary.addMaterial`. */
  readonly materials: readonly { readonly name: string; readonly values: Values }[];
}

/** Options of `objectsOfModel`. */
export interface UnpackOptions {
  /** Prefix of each material's name: 'robot/'. */
  readonly materialFolder?: string;
  /** Whether the objects cast shadows. Default true. */
  readonly castShadow?: boolean;
  /** Whether the objects receive shadows. Default true. */
  readonly receiveShadow?: boolean;
  /**
   * Values of the surface fields for the ObjectRenderers of one material of the model, by the `material`'s name; for
   * all ObjectRenderers when that is ''.
   */
  readonly wears?: { readonly material: string; readonly values: Values };
}

type Flags = Object3D & {
  readonly isMesh?: boolean;
  readonly isInstancedMesh?: boolean;
  readonly isLight?: boolean;
  readonly isCamera?: boolean;
};

/** Text of field values as a key: equal values give equal texts. */
const textOf = (values: Values): string =>
  JSON.stringify(Object.entries(values).toSorted(([a], [b]) => (a < b ? -1 : 1)));

/**
 * Reason that part of a model needs a ModelRenderer; null when all of the model can become objects (see
 * `objectsOfModel`).
 */
export const whatKeepsTogether = (model: Model): KeptFor | null => keptTogether(model)[0]?.reason ?? null;

/** Name of the object that draws several nodes of a model together. */
export function objectOfPart(nodes: readonly Object3D[]): string {
  const mesh = nodes.length === 1 ? nodes[0] : nodes.find((node) => 'isMesh' in node);
  return mesh?.name || nodes[0].name || nodes[0].type;
}

const instanceMatrix = new Matrix4();
const instanceTurn = new Quaternion();
const instancePlace = new Vector3();
const instanceScale = new Vector3();

/**
 * Makes GameObjects that look like a model: meshes with the parts of the model in the library, materials made of
 * fields, lights and cameras, an object for each instance of a mesh. Parts that `keptTogether` returns stay one object
 * each, with a ModelRenderer that draws these `parts` of the model.
 * @param name - name of the loaded model in the library
 */
export function objectsOfModel(
  model: Model,
  assets: AssetLibrary,
  name: string,
  { materialFolder = '', castShadow = true, receiveShadow = true, wears }: UnpackOptions = {},
): ObjectsOfModel {
  const parts = modelParts(model, name);
  const kept = keptTogether(model);
  const alone = new Map<Object3D, KeptPart>();
  /** Unsplittable parts of several nodes (such as a skeleton and its meshes), by the common ancestor of the nodes. */
  const several = new Map<Object3D, KeptPart[]>();
  const placesOfSeveral = new Set<Object3D>();
  for (const part of kept) {
    if (part.nodes.length === 1) {
      alone.set(part.nodes[0], part);
      continue;
    }
    const above = commonAncestor(part.nodes);
    const parts = several.get(above);
    if (parts) parts.push(part);
    else several.set(above, [part]);
    for (const node of part.nodes) placesOfSeveral.add(node);
  }
  const made = new Map<Material, string | null>();
  const materials: { name: string; values: Values }[] = [];

  /** Names of materials by their values, both of the library and made here. */
  const byValues = new Map<string, string[]>();
  const taken = new Set<string>();
  const numbers = new Map<string, number>();
  const note = (text: string, of: string): void => {
    const names = byValues.get(text);
    if (names) names.push(of);
    else byValues.set(text, [of]);
  };
  for (const each of assets.materialAssets) note(textOf(each.changedValues()), each.name);

  const nameOfMaterial = (material: Material): string | null => {
    if (!made.has(material)) made.set(material, makeMaterial(material));
    return made.get(material)!;
  };
  const makeMaterial = (material: Material): string | null => {
    const values = materialValuesOf(material, (texture: Texture) => parts.get(texture) ?? null);
    if (!values) return parts.get(material) ?? null;
    const wanted = `${materialFolder}${material.name.replaceAll('/', '-').trim() || 'Material'}`;
    const text = textOf(values);
    const isOfName = (each: string): boolean =>
      each === wanted || (each.startsWith(`${wanted} `) && /^\d+$/.test(each.slice(wanted.length + 1)));
    const same = byValues.get(text)?.find(isOfName);
    if (same !== undefined) return same;
    for (let n = numbers.get(wanted) ?? 1; ; n++) {
      const free = n === 1 ? wanted : `${wanted} ${n}`;
      if (taken.has(free) || assets.has(free)) continue;
      materials.push({ name: free, values });
      taken.add(free);
      numbers.set(wanted, n + 1);
      note(text, free);
      return free;
    }
  };

  const convert = (object: Flags): GameObject => {
    const gameObject = objectLike(object);
    const part = alone.get(object);
    if (part) {
      addParts(gameObject, part);
      return gameObject;
    }
    if (object.isInstancedMesh) addInstances(gameObject, object as unknown as InstancedMesh);
    else if (object.isMesh) addMesh(gameObject, object as unknown as Mesh);
    if (object.isLight) {
      const values = lightValues(object as unknown as ThreeLight);
      const profile = model.profileOf(object);
      if (values && profile) {
        const { maximumIntensity: most } = profile;
        const intensity = most > 0 ? (values.intensity as number) / most : 0;
        Object.assign(values, { profile: parts.get(profile) ?? null, profileIntensity: true, intensity });
      }
      if (values) gameObject.addComponent(Light, values);
    }
    const shape = shapeLightValues(object.userData.farolLight);
    if (shape) gameObject.addComponent(Light, shape);
    if (object.isCamera) gameObject.addComponent(Camera, cameraValues(object as unknown as PerspectiveCamera));
    for (const child of childrenOf(object)) gameObject.add(child);
    return gameObject;
  };
  const childrenOf = (object: Object3D): GameObject[] => {
    const children = object.children.filter(
      (child) => child !== (object as unknown as DirectionalLight).target && !placesOfSeveral.has(child),
    );
    return [
      ...children.map(convert),
      ...(several.get(object) ?? []).map((part) => {
        const gameObject = new GameObject(objectOfPart(part.nodes));
        addParts(gameObject, part);
        return gameObject;
      }),
    ];
  };
  const addParts = (gameObject: GameObject, part: KeptPart): void => {
    gameObject.addComponent(ModelRenderer, {
      model: name,
      parts: partsText(model.scene, part.nodes),
      castShadow,
      receiveShadow,
      ...(wears ? { ...wears.values, surfaceMaterial: wears.material } : {}),
    });
  };
  const addMesh = (gameObject: GameObject, { geometry, material }: Mesh, instanced = false): void => {
    const [first] = [material].flat();
    gameObject.addComponent(ObjectRenderer, {
      mesh: parts.get(geometry) ?? null,
      ['isShaderMaterial' in first ? 'shader' : 'material']: nameOfMaterial(first),
      castShadow,
      receiveShadow,
      ...(instanced ? { instanced } : {}),
      ...(wears && (wears.material === '' || wears.material === first.name) ? wears.values : {}),
    });
  };
  const addInstances = (gameObject: GameObject, mesh: InstancedMesh): void => {
    for (let i = 0; i < mesh.count; i++) {
      mesh.getMatrixAt(i, instanceMatrix);
      instanceMatrix.decompose(instancePlace, instanceTurn, instanceScale);
      const each = new GameObject(`${gameObject.name} ${i + 1}`);
      each.transform.position = instancePlace.toArray();
      each.transform.setQuaternion(instanceTurn);
      each.transform.scale = instanceScale.toArray();
      addMesh(each, mesh, true);
      gameObject.add(each);
    }
  };
  return { objects: childrenOf(model.scene), materials };
}

const lightTypes = {
  AmbientLight: 'ambient',
  HemisphereLight: 'hemisphere',
  DirectionalLight: 'directional',
  PointLight: 'point',
  SpotLight: 'spot',
  RectAreaLight: 'rectangle',
} as const;

/** Field values of a Light component that equals a three.js light; null for kinds of lights that Farol lacks. */
function lightValues(light: ThreeLight): Record<string, FieldValue> | null {
  const type = (lightTypes as Readonly<Record<string, (typeof lightTypes)[keyof typeof lightTypes]>>)[light.type];
  if (!type) return null;
  const values: Record<string, FieldValue> = {
    type,
    diffuse: [light.color.r, light.color.g, light.color.b],
    intensity: light.intensity,
  };
  if (type === 'point' || type === 'spot') {
    const { distance, decay, userData } = light as SpotLight;
    // with another attenuation, three's `distance` and `decay` are only a nearest fit, so they are not copied
    const isPhysical = (userData.farol as FarolLightData | undefined)?.attenuation === undefined;
    if (isPhysical) Object.assign(values, { range: distance, decay });
  }
  if (type === 'rectangle') {
    const { width, height, userData } = light as RectAreaLight;
    const { shape, range = 0 } = (userData.farol ?? {}) as FarolLightData;
    Object.assign(values, { type: shape ?? type, width, height, areaRange: range });
  }
  if (type === 'spot') {
    const { angle, penumbra } = light as SpotLight;
    Object.assign(values, { cutoff: Math.min(Math.PI / 2, Math.max(0.01, angle)), penumbra });
  }
  return { ...values, ...ownValues(light.userData.farol as FarolLightData | undefined) };
}

/** Fields of a Light for properties that only Farol's lights have. */
function ownValues({ ambient, specular, spotExponent, attenuation }: FarolLightData = {}): Record<string, FieldValue> {
  const values: Record<string, FieldValue> = {};
  if (ambient) values.ambient = ambient;
  if (specular) Object.assign(values, { ownSpecular: true, specular });
  if (spotExponent) values.exponent = Math.min(1000, spotExponent);
  if (!attenuation) return values;
  const { kind, ...numbers } = attenuation;
  Object.assign(values, { attenuation: kind, ...numbers });
  if (kind === 'near-far') values.far = Math.max(0.001, values.far as number);
  return values;
}

const SHAPE_FIELDS = ['type', 'width', 'height', 'diffuse', 'intensity', 'areaRange'] as const;

/** Fields of an area Light, from a node's extras that the editor's glTF export wrote; null for other extras. */
function shapeLightValues(extras: unknown): Record<string, FieldValue> | null {
  if (typeof extras !== 'object' || extras === null) return null;
  const values: Record<string, FieldValue> = {};
  for (const name of SHAPE_FIELDS) {
    const value = (extras as Record<string, unknown>)[name];
    if (checkFieldValue(Light.fields[name], value) === null) values[name] = value as FieldValue;
  }
  return ['rectangle', 'disc', 'tube'].includes(values.type as string) ? values : null;
}

function cameraValues(camera: PerspectiveCamera | OrthographicCamera): Record<string, FieldValue> {
  const { near, far } = camera;
  const depths = { near: Math.max(near, 0.0001), far: Math.max(far, 0.001) };
  if ('isPerspectiveCamera' in camera) {
    const fov = Math.min(3.1, Math.max(0.01, ((camera as PerspectiveCamera).fov * Math.PI) / 180));
    return { projection: 'perspective', fov, ...depths };
  }
  const { top, bottom } = camera as OrthographicCamera;
  return { projection: 'orthographic', size: Math.max(0.001, top - bottom), ...depths };
}
