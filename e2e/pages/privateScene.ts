import * as THREE from 'three';

// oxlint-disable-next-line typescript/no-explicit-any -- what TypeScript asks of the base of a mixin
type Class = new (...args: any[]) => object;

/** A host's class that keeps properties of three's in private fields, as TypeScript compiles those: only its own objects have them. */
function withPrivate<C extends Class>(Base: C, ...names: string[]): C {
  const Private = class extends Base {};
  for (const name of names) {
    const values = new WeakMap<object, unknown>();
    Object.defineProperty(Private.prototype, name, {
      get(this: object) {
        if (!values.has(this)) throw new TypeError(`Cannot read private member #${name} of another object`);
        return values.get(this);
      },
      set(this: object, value: unknown) {
        values.set(this, value);
      },
    });
  }
  return Private;
}

const Material = withPrivate(THREE.MeshPhysicalMaterial, 'color', 'roughness', 'opacity', 'alphaHash', '_clearcoat');
const Mesh = withPrivate(THREE.Mesh, 'castShadow', 'receiveShadow', 'material');
const Scene = withPrivate(THREE.Scene, 'background', 'fog');
const Spot = withPrivate(THREE.SpotLight, 'color', 'intensity', 'distance', 'penumbra', 'shadow');
const Shadow = withPrivate(shadowClass(), 'bias', 'mapSize', 'radius');
const Camera = withPrivate(THREE.PerspectiveCamera, 'near', 'far', 'zoom');

/** three does not export it. */
function shadowClass(): new () => THREE.SpotLightShadow {
  return new THREE.SpotLight().shadow.constructor as new () => THREE.SpotLightShadow;
}

/** A scene of such classes, with shadows. */
export function privateScene(width: number, height: number) {
  const scene = new Scene();
  scene.background = new THREE.Color(0x224466);
  scene.fog = new THREE.Fog(0x224466, 5, 12);
  const camera = new Camera(50, width / height, 0.1, 40);
  camera.position.set(0, 1.5, 6);
  camera.lookAt(0, 0, 0);
  const material = new Material({ color: 0x88bbff, roughness: 0.3, clearcoat: 0.5 });
  const ball = new Mesh(new THREE.SphereGeometry(0.8, 32, 16), material);
  const film = new Mesh(
    new THREE.PlaneGeometry(1.5, 1.5),
    new Material({ transparent: true, opacity: 0.5, side: THREE.DoubleSide }),
  );
  film.position.set(1.2, 0, 1);
  const hashed = new Mesh(new THREE.BoxGeometry(), new Material({ alphaHash: true, opacity: 0.8 }));
  hashed.position.x = -1.6;
  const ground = new Mesh(new THREE.PlaneGeometry(12, 12), new Material({ color: 0xaaaaaa, roughness: 0.8 }));
  ground.rotation.x = -Math.PI / 2;
  ground.position.y = -0.8;
  for (const mesh of [ball, film, hashed, ground]) mesh.castShadow = mesh.receiveShadow = true;
  const spot = new Spot(0xffeecc, 60, 15, 0.6, 0.3);
  spot.shadow = new Shadow();
  spot.shadow.bias = -0.002;
  spot.position.set(2, 5, 3);
  spot.castShadow = true;
  scene.add(ball, film, hashed, ground, spot, spot.target, new THREE.AmbientLight(0xffffff, 0.2));
  return { scene, camera, material };
}
