import * as THREE from 'three';
import { random } from './random';

/** A fault of a host's code within a frame: sets it up, and returns a function that takes it back. */
type Fault = () => () => void;

const thrown = new Error('thrown by the host');
const fail = () => {
  throw thrown;
};

/** A scene with every list of three's, nested lights and shadows, and the faults that a host's code can make in it. */
export function brokenScene(width: number, height: number) {
  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(50, width / height, 0.1, 50);
  camera.position.set(0, 1, 6);
  const lamp = new THREE.PointLight(0xff8844, 20, 9);
  lamp.position.set(2, 1, 2);
  const spot = new THREE.SpotLight(0x88aaff, 60, 12, 0.6, 0.5);
  spot.position.set(-2, 4, 3);
  spot.castShadow = true;
  spot.shadow.mapSize.set(128, 128);
  const sun = new THREE.DirectionalLight(0xffffff, 0.5);
  const standard = (color: number, more: THREE.MeshStandardMaterialParameters = {}) =>
    new THREE.MeshStandardMaterial({ color, ...more });
  const ball = new THREE.Mesh(new THREE.SphereGeometry(0.8), standard(0xffffff));
  const box = new THREE.Mesh(new THREE.BoxGeometry(), standard(0x88ff88, { roughness: 0.4 }));
  box.position.set(-1.5, 0, 0.5);
  const veil = new THREE.Mesh(
    new THREE.PlaneGeometry(2, 2),
    standard(0xff88ff, { transparent: true, opacity: 0.5, side: THREE.DoubleSide }),
  );
  veil.position.set(0.8, 0.3, 1.5);
  const glass = new THREE.Mesh(new THREE.SphereGeometry(0.5), new THREE.MeshPhysicalMaterial({ transmission: 0.9 }));
  glass.position.set(1.6, -0.2, 1);
  const toon = new THREE.Mesh(new THREE.TorusGeometry(0.4, 0.2), new THREE.MeshToonMaterial({ color: 0xffcc00 }));
  toon.position.set(-0.6, 1.2, 0.5);
  const ground = new THREE.Mesh(new THREE.PlaneGeometry(10, 10), standard(0x999999));
  ground.rotation.x = -Math.PI / 2;
  ground.position.y = -0.9;
  for (const mesh of [ball, box, toon]) mesh.castShadow = true;
  ground.receiveShadow = true;
  scene.add(new THREE.Group().add(lamp), spot, spot.target, sun, ball, box, veil, glass, toon, ground);
  scene.add(new THREE.AmbientLight(0xffffff, 0.2));
  return { scene, camera, ball, box, veil, glass, toon, ground, lamp, spot };
}

/**
 * Faults by name, in `brokenScene`.
 * @param render - what callbacks draw by, in the place of the renderer's own
 */
export function faultsOf(
  { scene, camera, ball, veil, glass, toon, ground, lamp }: ReturnType<typeof brokenScene>,
  webgl: THREE.WebGLRenderer,
  render: THREE.WebGLRenderer['render'],
): Record<string, Fault> {
  const target = new THREE.WebGLRenderTarget(16, 16);
  const inner = new THREE.Scene();
  const innerMesh = new THREE.Mesh(ball.geometry, new THREE.MeshStandardMaterial());
  innerMesh.onBeforeRender = fail;
  inner.add(innerMesh, new THREE.PointLight());
  const cube = new THREE.CubeCamera(0.1, 20, new THREE.WebGLCubeRenderTarget(8));
  const set = <T extends object, K extends keyof T>(object: T, key: K, value: T[K]): Fault => {
    return () => {
      const had = Object.getOwnPropertyDescriptor(object, key);
      Object.defineProperty(object, key, { value, writable: true, enumerable: true, configurable: true });
      return () => (had ? Object.defineProperty(object, key, had) : Reflect.deleteProperty(object, key));
    };
  };
  const getter = (object: object, key: string): Fault => {
    return () => {
      const had = Object.getOwnPropertyDescriptor(object, key)!;
      Object.defineProperty(object, key, { get: fail, enumerable: true, configurable: true });
      return () => Object.defineProperty(object, key, had);
    };
  };
  const added = (object: THREE.Object3D): Fault => {
    return () => {
      scene.add(object);
      return () => scene.remove(object);
    };
  };
  const fresh =
    (make: () => THREE.Object3D): Fault =>
    () =>
      added(make())();
  const without = (key: 'material' | 'geometry', casts: boolean) =>
    fresh(() => {
      const mesh = new THREE.Mesh(ball.geometry, new THREE.MeshStandardMaterial());
      mesh.castShadow = casts;
      mesh[key] = undefined as never;
      return mesh;
    });
  const compiled = (make: () => THREE.Material, casts = false) =>
    fresh(() => {
      const mesh = new THREE.Mesh(ball.geometry, make());
      mesh.material.onBeforeCompile = fail;
      if (casts) mesh.customDepthMaterial = Object.assign(new THREE.MeshDepthMaterial(), { onBeforeCompile: fail });
      mesh.castShadow = casts;
      return mesh;
    });
  /** Draws something else to a target, which fails half way. */
  const nested = () => {
    webgl.setRenderTarget(target);
    render(inner, camera);
  };
  const nestedCube = () => {
    cube.update(Object.create(webgl, { render: { value: render } }) as THREE.WebGLRenderer, inner);
  };
  return {
    'object.onBeforeRender': set(ball, 'onBeforeRender', fail),
    'onBeforeRender of what is transparent': set(veil, 'onBeforeRender', fail),
    'onBeforeRender of what transmits': set(glass, 'onBeforeRender', fail),
    'onBeforeRender of what no G-buffer holds': set(toon, 'onBeforeRender', fail),
    'object.onAfterRender': set(ground, 'onAfterRender', fail),
    'object.onBeforeShadow': set(ball, 'onBeforeShadow', fail),
    // shadow maps are drawn in each frame only where an object has both callbacks
    'object.onAfterShadow': () => {
      const mends = [set(ball, 'onBeforeShadow', () => undefined)(), set(ball, 'onAfterShadow', fail)()];
      return () => mends.forEach((mend) => mend());
    },
    'material.onBeforeRender': set(ball.material as THREE.Material, 'onBeforeRender', fail),
    'scene.onBeforeRender': set(scene, 'onBeforeRender', fail),
    'scene.onAfterRender': set(scene, 'onAfterRender', fail),
    onBeforeCompile: compiled(() => new THREE.MeshStandardMaterial()),
    'onBeforeCompile of what transmits': compiled(() => new THREE.MeshPhysicalMaterial({ transmission: 0.5 })),
    'onBeforeCompile of a depth material': compiled(() => new THREE.MeshStandardMaterial(), true),
    'no material': without('material', false),
    'no material, casts': without('material', true),
    'no geometry': without('geometry', false),
    'no geometry, casts': without('geometry', true),
    'a getter of a mesh': getter(toon, 'material'),
    'a getter of a light': getter(lamp, 'color'),
    'a getter of a layer': getter(ground, 'layers'),
    'a nested render': set(ball, 'onBeforeRender', nested),
    'a nested render of the scene': set(scene, 'onBeforeRender', nested),
    'a CubeCamera': set(ground, 'onBeforeRender', nestedCube),
    'a sort': () => {
      webgl.setOpaqueSort(fail);
      return () => webgl.setOpaqueSort(null as never);
    },
  };
}

/** Message that `action` throws; '' if it throws nothing. */
export function messageOf(action: () => void): string {
  try {
    action();
    return '';
  } catch (error) {
    return error === thrown ? 'the host’s own' : String(error);
  }
}

/** Draws broken frames, each by a fault at random. @returns what was thrown, by fault */
export function breakFrames(
  faults: Record<string, Fault>,
  count: number,
  seed: number,
  render: () => void,
): Record<string, string> {
  const next = random(seed);
  const names = Object.keys(faults);
  const messages: Record<string, string> = {};
  for (let i = 0; i < count; i++) {
    // first each fault once, then faults at random
    const name = names[i < names.length ? i : Math.floor(next() * names.length)];
    const mend = faults[name]();
    messages[name] = messageOf(render);
    mend();
  }
  return messages;
}
