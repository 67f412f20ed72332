import * as THREE from 'three';
import { batched, instanced, morphed, skinned } from '../materialScene';
import type { Shape, ThingFacts, Trait } from './SceneFacts';

const shapes: Readonly<Record<Shape, () => THREE.BufferGeometry>> = {
  ball: () => new THREE.SphereGeometry(0.6, 24, 16),
  box: () => new THREE.BoxGeometry(0.9, 0.9, 0.9),
  knot: () => new THREE.TorusKnotGeometry(0.4, 0.14, 48, 8),
  sheet: () => new THREE.PlaneGeometry(1, 1),
  tiles: () => new THREE.PlaneGeometry(1, 1, 40, 40),
  cone: () => new THREE.ConeGeometry(0.5, 1, 9),
  bowl: () => new THREE.SphereGeometry(0.6, 16, 12, 0, Math.PI),
  crystal: () => new THREE.IcosahedronGeometry(0.6, 1),
};

/** Numbers from 0.25 to 1 that look like chance. */
const shade = (i: number) => 0.25 + ((i * 37) % 100) / 134;

function interleave(geometry: THREE.BufferGeometry): THREE.BufferGeometry {
  const { position, normal } = geometry.attributes;
  const data = new THREE.InterleavedBuffer(new Float32Array(position.count * 6), 6);
  const places = new THREE.InterleavedBufferAttribute(data, 3, 0);
  const normals = new THREE.InterleavedBufferAttribute(data, 3, 3);
  for (let i = 0; i < position.count; i++) {
    places.setXYZ(i, position.getX(i), position.getY(i), position.getZ(i));
    normals.setXYZ(i, normal.getX(i), normal.getY(i), normal.getZ(i));
  }
  return geometry.setAttribute('position', places).setAttribute('normal', normals);
}

const traits: Readonly<Record<Trait, (geometry: THREE.BufferGeometry, flat: boolean) => THREE.BufferGeometry>> = {
  interleaved: interleave,
  'without index': (geometry) => strip(geometry),
  'wide index': (geometry) =>
    geometry.index ? geometry.setIndex(new THREE.Uint32BufferAttribute([...geometry.index.array], 1)) : geometry,
  bytes: (geometry) => {
    const bytes = Int8Array.from(geometry.attributes.normal.array, (value) => Math.round(value * 127));
    return geometry.setAttribute('normal', new THREE.BufferAttribute(bytes, 3, true));
  },
  range: (geometry) => {
    const count = geometry.index?.count ?? geometry.attributes.position.count;
    geometry.setDrawRange(Math.floor(count / 9) * 3, Math.floor(count / 6) * 3);
    return geometry;
  },
  tangents: (geometry) => {
    if (geometry.index) geometry.computeTangents();
    return geometry;
  },
  'without normals': (geometry, flat) => (flat ? geometry.deleteAttribute('normal') : geometry),
};

function buildGeometry({ shape = 'ball', traits: names = [], material = {} }: ThingFacts): THREE.BufferGeometry {
  let geometry = shapes[shape]();
  const { uv, position } = geometry.attributes;
  geometry.setAttribute('uv1', uv);
  if (material.vertexColors === true) {
    const size = material.transparent === true ? 4 : 3;
    const colors = Float32Array.from({ length: position.count * size }, (_, i) => shade(i));
    geometry.setAttribute('color', new THREE.BufferAttribute(colors, size));
  }
  for (const name of names) geometry = traits[name](geometry, material.flatShading === true);
  return geometry;
}

function morphedInstances(geometry: THREE.BufferGeometry, material: THREE.Material): THREE.InstancedMesh {
  const { position } = geometry.attributes;
  const target = Float32Array.from(
    { length: position.count * 3 },
    (_, i) => position.getComponent(Math.floor(i / 3), i % 3) * (1 + (i % 5) * 0.1),
  );
  geometry.morphAttributes.position = [new THREE.BufferAttribute(target, 3)];
  const mesh = new THREE.InstancedMesh(geometry, material, 4);
  const shape = new THREE.Mesh(geometry, material);
  for (let i = 0; i < 4; i++) {
    mesh.setMatrixAt(i, new THREE.Matrix4().makeTranslation((i % 2) - 0.5, (i >> 1) - 0.5, i * 0.1));
    shape.morphTargetInfluences = [i / 4];
    mesh.setMorphAt(i, shape);
  }
  return mesh;
}

/** Groups of triangles with a material each; the second is the facts' own. */
function ofMaterials(geometry: THREE.BufferGeometry, material: THREE.Material): THREE.Mesh {
  const count = geometry.index?.count ?? geometry.attributes.position.count;
  const part = Math.floor(count / 12) * 3;
  geometry.clearGroups();
  [0, 1, 2, 3].forEach((i) => geometry.addGroup(i * part, part, i));
  const veil = new THREE.MeshStandardMaterial({ color: 0xff88ff, transparent: true, opacity: 0.5 });
  // three draws no group whose material is missing
  const materials = [new THREE.MeshLambertMaterial({ color: 0x88ff88 }), material, veil, null];
  return new THREE.Mesh(geometry, materials as THREE.Material[]);
}

function levels(geometry: THREE.BufferGeometry, material: THREE.Material): THREE.LOD {
  const lod = new THREE.LOD();
  lod.addLevel(new THREE.Mesh(geometry, material), 0);
  lod.addLevel(new THREE.Mesh(new THREE.IcosahedronGeometry(0.6, 0), material), 6);
  return lod;
}

/** Geometry without an index: `computeLineDistances` needs vertices in the order in which they are drawn. */
const strip = (geometry: THREE.BufferGeometry) => (geometry.index ? geometry.toNonIndexed() : geometry);

function objectOf(facts: ThingFacts, material: THREE.Material): THREE.Object3D {
  const make = () => buildGeometry(facts);
  switch (facts.as) {
    case 'instanced':
      return instanced(material);
    case 'batched':
      return batched(material);
    case 'skinned':
      return skinned(material);
    case 'morphed':
      return morphed(material);
    case 'morphed instances':
      return morphedInstances(make(), material);
    case 'levels':
      return levels(make(), material);
    case 'of materials':
      return ofMaterials(make(), material);
    case 'line':
      return new THREE.Line(strip(make()), material).computeLineDistances();
    case 'segments':
      return new THREE.LineSegments(new THREE.EdgesGeometry(make()), material).computeLineDistances();
    case 'loop':
      return new THREE.LineLoop(strip(make()), material).computeLineDistances();
    case 'points':
      return new THREE.Points(make(), material);
    case 'sprite':
      return new THREE.Sprite(material as THREE.SpriteMaterial);
    default:
      return new THREE.Mesh(make(), material);
  }
}

/** Callbacks run after the method of the object's class: a BatchedMesh lists its draws there. */
const callbacks: Readonly<Record<NonNullable<ThingFacts['callback']>, (object: THREE.Object3D) => void>> = {
  clears: (object) => {
    const { onBeforeRender } = object;
    object.onBeforeRender = (renderer, ...rest) => {
      onBeforeRender.call(object, renderer, ...rest);
      renderer.clearDepth();
    };
  },
  colours: (object) => {
    const { onBeforeRender } = object;
    object.onBeforeRender = (renderer, scene, camera, geometry, material, group) => {
      onBeforeRender.call(object, renderer, scene, camera, geometry, material, group);
      (material as THREE.MeshLambertMaterial).color?.set(0x4488ff);
    };
  },
  listens: (object) => {
    object.onAfterRender = () => {};
  },
};

type Place = Pick<ThingFacts, 'position' | 'rotation' | 'scale'>;

/** Puts an object where facts say. */
export function place<T extends THREE.Object3D>(object: T, { position, rotation, scale }: Place): T {
  if (position) object.position.fromArray(position);
  if (rotation) object.rotation.fromArray([...rotation]);
  if (scale) object.scale.fromArray(scale);
  return object;
}

/** @returns the object, within its parents */
export function buildThing(facts: ThingFacts, material: THREE.Material): THREE.Object3D {
  const object = place(objectOf(facts, material), facts);
  object.traverse((part) => {
    part.castShadow = facts.castShadow ?? false;
    part.receiveShadow = facts.receiveShadow ?? false;
    part.frustumCulled = facts.frustumCulled ?? true;
    if (facts.layer !== undefined) part.layers.set(facts.layer);
  });
  object.renderOrder = facts.renderOrder ?? 0;
  if (facts.callback) callbacks[facts.callback](object);
  let outer = object;
  for (const parent of facts.parents ?? []) {
    const group = place(new THREE.Group(), parent);
    group.add(outer);
    outer = group;
  }
  return outer;
}
