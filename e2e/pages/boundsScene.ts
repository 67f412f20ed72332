import { LightField } from '@farol/renderer/light-field';
import * as THREE from 'three';

export interface BoundsScene {
  readonly scene: THREE.Scene;
  readonly cameras: Readonly<Record<string, THREE.Camera>>;
  /** Cameras that see a small part of it. */
  readonly narrow: readonly THREE.Camera[];
  /** Lights of which two in three are as bright at the end of their range as before it; to be added to the scene. */
  readonly lights: THREE.Object3D;
  /** Those lights one by one, for stock three, and as data in `field`. */
  readonly plain: THREE.Object3D;
  readonly field: LightField;
}

/** Panels side by side, each at a depth of its own, and lights among them. Where a light is cut short, it shows. */
export function boundsScene(width: number, height: number): BoundsScene {
  let seed = 7;
  const random = (low: number, high: number) => {
    seed = (Math.imul(seed, 1103515245) + 12345) >>> 0;
    return low + ((high - low) * (seed >>> 8)) / 2 ** 24;
  };
  const place = (row: number, column: number) =>
    new THREE.Vector3((column - 5.5) * 1.4, (row - 3) * 1.2, random(-3, 1));
  const scene = new THREE.Scene();
  const material = new THREE.MeshLambertMaterial();
  const panel = new THREE.PlaneGeometry(1.5, 1.3);
  for (let i = 0; i < 84; i++) {
    const mesh = new THREE.Mesh(panel, material);
    mesh.position.copy(place(Math.floor(i / 12), i % 12));
    mesh.rotation.set(random(-0.5, 0.5), random(-0.5, 0.5), 0);
    scene.add(mesh);
  }
  const lights = new THREE.Group();
  const plain = new THREE.Group();
  const field = new LightField(60, { spots: true });
  for (let i = 0; i < 60; i++) {
    const range = random(0.4, 2.2);
    const at = place(random(0, 7), random(0, 12));
    const angle = i % 2 ? random(0.1, 1) : random(1, 1.4);
    const [x, y, z] = [random(-1, 1), random(-1, 1), random(-1, 1)];
    // with a decay of 0 two in three do not weaken before the end of the range: if cut short, it shows
    const light =
      i % 3 === 2
        ? new THREE.SpotLight(0xffffff, 60, range, angle, 0.05, 0)
        : new THREE.PointLight(0xffffff, 60, range, 0);
    light.position.copy(at);
    field.setPoint(i, at.x, at.y, at.z, range, 60, 60, 60, 0);
    if (light instanceof THREE.SpotLight) {
      light.target.position.set(x, y, z).add(at);
      field.setCone(i, x, y, z, angle, 0.05);
    }
    const even = light.clone();
    if (i % 3 !== 0) {
      even.color.set(0);
      even.intensity = 1;
      even.userData.farol = { ambient: [1, 1, 1], attenuation: { kind: 'near-far', near: 0.9 * range, far: range } };
    }
    for (const [one, group] of [
      [light, plain],
      [even, lights],
    ] as const) {
      group.add(one);
      if (one instanceof THREE.SpotLight) group.add(one.target);
    }
  }
  const perspective = new THREE.PerspectiveCamera(50, width / height, 0.3, 30);
  perspective.position.set(0.3, 0.2, 8);
  const inside = new THREE.PerspectiveCamera(70, width / height, 0.05, 30);
  inside.position.set(-1, 0.5, 1.2);
  inside.rotation.y = 0.3;
  const orthographic = new THREE.OrthographicCamera(-7, 7, 4, -4, 0.5, 20);
  orthographic.position.z = 8;
  // the tiles of the picture lie otherwise over the lights, and the far plane cuts lights and panels
  const moved = new THREE.PerspectiveCamera(50, width / height, 0.3, 7.5);
  moved.position.set(-0.9, 0.7, 6);
  // many lights touch the sides of what they see
  const narrow = [0, 1, 2, 3].map((i) => {
    const camera = new THREE.PerspectiveCamera(8, width / height, 0.3, 30);
    camera.position.set(0, 0, 8);
    camera.lookAt(i * 3 - 4.5, 1, -1);
    return camera;
  });
  return {
    scene,
    cameras: { moved, perspective, 'among the lights': inside, orthographic },
    narrow,
    lights,
    plain,
    field,
  };
}
