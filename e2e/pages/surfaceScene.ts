import { setSurface, Surface } from '@farol/renderer/surfaces';
import * as THREE from 'three';

/** GLSL of a surface that bends and paints a mesh; every step of `displace` rounds alike on CPU and GPU. */
export const SURFACE = `uniform float strength; // = 0.5 [0, 1, 0.01] Strength
uniform vec3 stripe; // = #ff8000 Stripes
float wave(vec3 p) { return 0.5 + 0.5 * sin(9.0 * p.x + 5.0 * p.y + 3.0); }
void displace(inout VertexData v) {
  v.positionOS = vec3(v.positionOS.x * 1.5, v.positionOS.y * 0.5, v.positionOS.z + 0.25);
  v.normalOS = v.normalOS.yxz;
}
void surface(inout SurfaceData s) {
  float w = wave(s.positionOS);
  s.color = mix(s.color, stripe, strength * w);
  s.roughness = 0.3 + 0.5 * w;
  s.metalness = 0.25 * w;
  s.normalVS = normalize(s.normalVS + 0.2 * vec3(w, 0.0, 0.0));
  s.emissive += vec3(0.0, 0.1, 0.2) * w;
}
`;

const PAINT = `float w = 0.5 + 0.5 * sin(9.0 * vRest.x + 5.0 * vRest.y + 3.0);
diffuseColor.rgb = mix(diffuseColor.rgb, vec3(1.0, 0.21586050011389926, 0.0), 0.5 * w);
`;
const LIT = `roughnessFactor = 0.3 + 0.5 * w;
metalnessFactor = 0.25 * w;
normal = normalize(normal + 0.2 * vec3(w, 0.0, 0.0));
totalEmissiveRadiance += vec3(0.0, 0.1, 0.2) * w;
`;

/** A material of three's own that does on the GPU what SURFACE paints, of a geometry of \`bent\`. */
function oracle(material: THREE.Material): THREE.Material {
  const unlit = 'isMeshBasicMaterial' in material;
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace('void main() {', 'attribute vec3 rest;\nvarying vec3 vRest;\nvoid main() {\nvRest = rest;')
      .replace('#include <beginnormal_vertex>', '#include <beginnormal_vertex>\nobjectNormal = objectNormal.yxz;');
    const place = unlit ? '#include <specularmap_fragment>' : '#include <emissivemap_fragment>';
    const own = unlit ? 'diffuseColor.rgb += vec3(0.0, 0.1, 0.2) * w;' : LIT;
    shader.fragmentShader = shader.fragmentShader
      .replace('void main() {', 'varying vec3 vRest;\nvoid main() {')
      .replace(place, `${place}\n${PAINT}${own}`);
  };
  return material;
}

/** A geometry whose positions the CPU has displaced; the former ones are \`rest\`. */
function bent(geometry: THREE.BufferGeometry): THREE.BufferGeometry {
  const { position } = geometry.attributes;
  geometry.setAttribute('rest', position.clone());
  for (let i = 0; i < position.count; i++)
    position.setXYZ(i, position.getX(i) * 1.5, position.getY(i) * 0.5, position.getZ(i) + 0.25);
  return geometry;
}

export type SurfaceWear = 'surface' | 'oracle' | 'none';

export interface SurfaceScene {
  readonly scene: THREE.Scene;
  readonly camera: THREE.PerspectiveCamera;
  readonly materials: readonly THREE.Material[];
  readonly surface: Surface | null;
}

/**
 * A plain mesh, an instanced one, a skinned one and an unlit one over a floor, under lights with a shadow.
 * @param wear - material of these meshes: with SURFACE, stock three's equal of it, or plain
 */
export function surfaceScene(width: number, height: number, wear: SurfaceWear): SurfaceScene {
  const scene = new THREE.Scene();
  const surface = wear === 'surface' ? new Surface('bends', SURFACE) : null;
  const materials: THREE.Material[] = [];
  const worn = (material: THREE.Material): THREE.Material => {
    materials.push(material);
    if (wear === 'oracle') return oracle(material);
    if (surface) setSurface(material, surface);
    return material;
  };
  const shape = (geometry: THREE.BufferGeometry) => (wear === 'oracle' ? bent(geometry) : geometry);
  const standard = () => new THREE.MeshStandardMaterial({ color: 0x4477cc, roughness: 0.6 });
  const add = (mesh: THREE.Mesh, x: number, y: number) => {
    mesh.position.set(x, y, 0);
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.frustumCulled = false;
    scene.add(mesh);
    return mesh;
  };
  const shared = worn(standard());
  add(new THREE.Mesh(shape(new THREE.SphereGeometry(0.6, 24, 16)), shared), -1.6, 0.8);
  const instanced = new THREE.InstancedMesh(shape(new THREE.TorusGeometry(0.3, 0.12, 8, 16)), shared, 2);
  instanced.setMatrixAt(0, new THREE.Matrix4().makeTranslation(0, 0.4, 0));
  instanced.setMatrixAt(1, new THREE.Matrix4().makeRotationX(0.8).setPosition(0, -0.5, 0.2));
  add(instanced, 0, 0.9);
  const skin = shape(new THREE.CylinderGeometry(0.25, 0.25, 1.2, 12, 6));
  const { position } = new THREE.CylinderGeometry(0.25, 0.25, 1.2, 12, 6).attributes;
  const weights = new Float32Array(position.count * 4);
  const indices = new Uint16Array(position.count * 4);
  for (let i = 0; i < position.count; i++) {
    const share = THREE.MathUtils.clamp(position.getY(i) / 1.2 + 0.5, 0, 1);
    weights.set([1 - share, share], i * 4);
    indices.set([0, 1], i * 4);
  }
  skin.setAttribute('skinWeight', new THREE.BufferAttribute(weights, 4));
  skin.setAttribute('skinIndex', new THREE.BufferAttribute(indices, 4));
  const skinned = new THREE.SkinnedMesh(skin, worn(standard()));
  const bones = [new THREE.Bone(), new THREE.Bone()];
  bones[0].add(bones[1]);
  skinned.add(bones[0]);
  skinned.bind(new THREE.Skeleton(bones));
  bones[1].rotation.z = 0.6;
  add(skinned, 1.5, 0.9);
  add(
    new THREE.Mesh(shape(new THREE.BoxGeometry(0.5, 0.5, 0.5)), worn(new THREE.MeshBasicMaterial({ color: 0x808080 }))),
    0.7,
    2,
  );
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(8, 8), new THREE.MeshStandardMaterial({ color: 0xaaaaaa }));
  floor.rotation.x = -Math.PI / 2;
  floor.receiveShadow = true;
  scene.add(floor);
  const spot = new THREE.SpotLight(0xffffff, 60, 12, 0.8, 0.5);
  spot.position.set(1, 5, 3);
  spot.castShadow = true;
  spot.shadow.mapSize.set(256, 256);
  spot.shadow.bias = -0.002;
  scene.add(spot, spot.target, new THREE.AmbientLight(0x404040));
  for (const x of [-2, 2]) {
    const light = new THREE.PointLight(0xffddaa, 6, 6);
    light.position.set(x, 1.5, 1.5);
    scene.add(light);
  }
  const camera = new THREE.PerspectiveCamera(45, width / height, 0.1, 20);
  camera.position.set(0, 2.2, 5);
  camera.lookAt(0, 0.7, 0);
  return { scene, camera, materials, surface };
}
