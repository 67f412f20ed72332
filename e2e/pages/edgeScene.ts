import * as THREE from 'three';
import type { TestScene } from './materialScene';

/** A scene of edges, with parts that move by themselves. */
export interface EdgeScene extends TestScene {
  /** Puts what moves where it is at a time (s): an object, a skin, a morph, instances, a batch. */
  setTime(seconds: number): void;
}

/** A pole of two bones: its tip turns with the second one. */
export function bentPole(material: THREE.Material): THREE.SkinnedMesh {
  const geometry = new THREE.BoxGeometry(0.25, 3, 0.25, 1, 12, 1);
  const { position } = geometry.attributes;
  const indices = new Uint16Array(position.count * 4);
  const weights = new Float32Array(position.count * 4);
  for (let i = 0; i < position.count; i++) {
    const along = (position.getY(i) + 1.5) / 3;
    indices[i * 4 + 1] = 1;
    weights[i * 4] = 1 - along;
    weights[i * 4 + 1] = along;
  }
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4));
  const root = new THREE.Bone();
  const tip = new THREE.Bone();
  root.add(tip);
  const mesh = new THREE.SkinnedMesh(geometry, material);
  mesh.add(root);
  mesh.bind(new THREE.Skeleton([root, tip]));
  return mesh;
}

function swellingBox(material: THREE.Material): THREE.Mesh {
  const geometry = new THREE.BoxGeometry(0.9, 0.9, 0.9);
  const swollen = geometry.attributes.position.clone();
  for (let i = 0; i < swollen.count; i++) swollen.setXYZ(i, swollen.getX(i) * 2, swollen.getY(i), swollen.getZ(i));
  geometry.morphAttributes.position = [swollen];
  const mesh = new THREE.Mesh(geometry, material);
  mesh.morphTargetInfluences = [0];
  return mesh;
}

/** Plain surfaces, so that what is aliased is their edges: a fence, turned boxes, a knot, and what moves. */
export function edgeScene(width: number, height: number): EdgeScene {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0.02, 0.03, 0.05);
  const white = new THREE.MeshStandardMaterial({ color: 0xdddddd, roughness: 0.9 });
  const red = new THREE.MeshStandardMaterial({ color: 0xcc4433, roughness: 0.9 });
  const box = new THREE.BoxGeometry(1, 1, 1);
  const fence = new THREE.InstancedMesh(box, white, 24);
  const matrix = new THREE.Matrix4();
  for (let i = 0; i < 24; i++) {
    matrix.makeScale(0.06, 1.6, 0.06).setPosition(-5 + i * 0.43, 0.3, -3);
    fence.setMatrixAt(i, matrix);
  }
  scene.add(fence);
  for (let i = 0; i < 6; i++) {
    const mesh = new THREE.Mesh(box, i % 2 ? white : red);
    mesh.position.set(-4 + i * 1.6, -0.9, 0.2 * i);
    mesh.rotation.set(0.3 * i, 0.4 + i, 0.2);
    scene.add(mesh);
  }
  const knot = new THREE.Mesh(new THREE.TorusKnotGeometry(0.8, 0.12, 96, 10), white);
  knot.position.set(3.2, 1.6, -1);
  scene.add(knot);
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(40, 40), new THREE.MeshLambertMaterial({ color: 0x556677 }));
  floor.rotation.x = -Math.PI / 2;
  floor.position.y = -1.6;
  scene.add(floor);

  const moving = new THREE.Mesh(box, red);
  const skin = bentPole(white);
  skin.position.set(-3, 1.2, 0);
  const morph = swellingBox(red);
  morph.position.set(0, 2.2, -0.5);
  const crowd = new THREE.InstancedMesh(box, white, 5);
  const batch = new THREE.BatchedMesh(3, 100, 200, red);
  const shape = batch.addGeometry(box);
  const ids = [0, 1, 2].map(() => batch.addInstance(shape));
  for (const mesh of [crowd, batch]) mesh.frustumCulled = false;
  scene.add(moving, skin, morph, crowd, batch);
  scene.add(new THREE.AmbientLight(0xffffff, 0.4));
  const sun = new THREE.DirectionalLight(0xffffff, 1.6);
  sun.position.set(2, 4, 3);
  const lamp = new THREE.PointLight(0xffddaa, 30, 20, 2);
  lamp.position.set(-2, 3, 3);
  scene.add(sun, lamp);
  const camera = new THREE.PerspectiveCamera(50, width / height, 0.1, 60);
  camera.position.set(0, 1, 8);
  camera.lookAt(0, 0.3, 0);
  const setTime = (seconds: number) => {
    moving.position.set(-1.2 + 0.8 * seconds, 0.7, 1.5);
    moving.rotation.set(0.4, 0.5 + seconds, 0.3);
    skin.skeleton.bones[1].rotation.z = 0.8 * Math.sin(seconds);
    skin.rotation.y = seconds;
    morph.morphTargetInfluences![0] = 0.5 + 0.5 * Math.sin(2 * seconds);
    for (let i = 0; i < 5; i++) {
      matrix.makeRotationZ(0.3 + seconds + i).scale(new THREE.Vector3(0.3, 0.3, 0.3));
      crowd.setMatrixAt(i, matrix.setPosition(1.2 + 0.7 * i - 0.6 * seconds, -0.1 + 0.1 * i, 1));
    }
    crowd.instanceMatrix.needsUpdate = true;
    ids.forEach((id, i) => {
      matrix.makeRotationZ(seconds + i).scale(new THREE.Vector3(0.4, 0.4, 0.4));
      batch.setMatrixAt(id, matrix.setPosition(-4 + 0.6 * i, 2.6 - 0.5 * seconds, -1));
    });
  };
  setTime(0);
  return { scene, camera, lights: [sun, lamp], setTime };
}
