import * as THREE from 'three';
import { WebGLNodesHandler } from 'three/addons/tsl/WebGLNodesHandler.js';
import { color, normalLocal, positionLocal, sin, uv, vec3 } from 'three/tsl';
import { MeshBasicNodeMaterial, MeshPhongNodeMaterial, MeshStandardNodeMaterial } from 'three/webgpu';

/** A scene of TSL's node materials, opaque and transparent, among and through others, under lights of each kind. */
export function nodeScene(webgl: THREE.WebGLRenderer, width: number, height: number) {
  webgl.setNodesHandler(new WebGLNodesHandler() as never);
  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(50, width / height, 0.1, 30);
  camera.position.set(0, 1, 6);
  const mesh = (geometry: THREE.BufferGeometry, material: THREE.Material, x: number, y: number, z: number) => {
    const made = new THREE.Mesh(geometry, material);
    made.position.set(x, y, z);
    scene.add(made);
    return made;
  };
  const standard = new MeshStandardNodeMaterial({ roughness: 0.4 });
  standard.colorNode = vec3(uv(), 0.5);
  standard.positionNode = positionLocal.add(normalLocal.mul(sin(positionLocal.y.mul(9)).mul(0.1)));
  const phong = new MeshPhongNodeMaterial();
  phong.colorNode = color(0x66ccff);
  const veil = new MeshBasicNodeMaterial({ transparent: true, opacity: 0.5 });
  veil.colorNode = color(0xffaa00);
  const plain = new THREE.MeshStandardMaterial({ color: 0x88ff88 });
  const film = new THREE.MeshStandardMaterial({ color: 0xff88ff, transparent: true, opacity: 0.6 });
  mesh(new THREE.SphereGeometry(0.8), standard, -0.9, 0, 0);
  // half in the box, half before it
  mesh(new THREE.BoxGeometry(), plain, -0.3, -0.2, 0.2);
  mesh(new THREE.TorusGeometry(0.6, 0.25), phong, 1.1, 0.2, 0);
  mesh(new THREE.PlaneGeometry(2, 1), veil, 0, 0.5, 1.5);
  mesh(new THREE.PlaneGeometry(1, 2), film, 0.6, 0.3, 2);
  mesh(new THREE.PlaneGeometry(1, 2), film, -0.6, 0.3, 1);
  const ground = mesh(new THREE.PlaneGeometry(10, 10), new THREE.MeshStandardMaterial(), 0, -0.9, 0);
  ground.rotation.x = -Math.PI / 2;
  const lamp = new THREE.PointLight(0xff8844, 15, 9);
  lamp.position.set(2, 1, 2);
  const sun = new THREE.DirectionalLight(0xffffff, 1);
  sun.position.set(-1, 2, 1);
  scene.add(new THREE.Group().add(lamp), sun, new THREE.AmbientLight(0xffffff, 0.2));
  return { scene, camera, ground, sun };
}
