import * as THREE from 'three';
import { shadowScene } from './shadowScene';

/** Lights of each kind with shadows over things of three's materials, in fog, seen from a rig that is turned. */
export function multiviewScene(): { scene: THREE.Scene; camera: THREE.PerspectiveCamera } {
  const { scene } = shadowScene(96, 96, { caster: 'mixed' });
  scene.background = new THREE.Color(0.1, 0.15, 0.2);
  scene.fog = new THREE.Fog(0x203040, 2, 20);
  const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 60);
  const rig = new THREE.Group();
  rig.position.set(0.5, 0.3, 5);
  rig.rotation.set(0, 0.2, 0.1);
  rig.add(camera);
  scene.add(rig);
  const sky = new THREE.CubeTexture(
    ['#f84', '#48f', '#8f4', '#f48', '#84f', '#4f8'].map((color) => {
      const canvas = Object.assign(document.createElement('canvas'), { width: 4, height: 4 });
      const context = canvas.getContext('2d')!;
      context.fillStyle = color;
      context.fillRect(0, 0, 4, 4);
      return canvas;
    }),
  );
  sky.needsUpdate = true;
  const materials = [
    new THREE.MeshPhysicalMaterial({ color: 0xff8844, roughness: 0.2, clearcoat: 1 }),
    new THREE.MeshPhongMaterial({ color: 0x44ff88, shininess: 60, envMap: sky }),
    new THREE.MeshLambertMaterial({ color: 0x8844ff, transparent: true, opacity: 0.6, side: THREE.DoubleSide }),
    new THREE.MeshToonMaterial({ color: 0xffff44 }),
    new THREE.MeshMatcapMaterial({ color: 0x88ffff }),
    new THREE.MeshNormalMaterial(),
    new THREE.MeshBasicMaterial({ envMap: sky }),
  ];
  materials.forEach((material, i) => {
    const ball = new THREE.Mesh(new THREE.SphereGeometry(0.35), material);
    ball.position.set(-2 + 0.7 * i, 1.2 + 0.3 * (i % 3), 2 - 0.5 * (i % 2));
    scene.add(ball);
  });
  // small, so that a list of another place lacks some
  for (let i = 0; i < 96; i++) {
    const lamp = new THREE.PointLight(new THREE.Color().setHSL(i / 96, 1, 0.5), 3, 0.7);
    lamp.position.set(-4 + ((i * 7) % 96) / 12, 0.25 + 0.8 * (i % 3), 4 - ((i * 11) % 96) / 12);
    scene.add(lamp);
  }
  return { scene, camera };
}

/** Calls of draws of WebGL while a function runs. */
export function countDraws(gl: WebGL2RenderingContext, run: () => void): number {
  let draws = 0;
  const names = ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'] as const;
  for (const name of names) {
    const own = gl[name].bind(gl) as (...args: unknown[]) => void;
    Object.assign(gl, { [name]: (...args: unknown[]) => (draws++, own(...args)) });
  }
  run();
  for (const name of names) Reflect.deleteProperty(gl, name);
  return draws;
}
