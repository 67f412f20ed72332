import * as THREE from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { Bench } from '../Bench';
import { Dice } from './Dice';

/** A material of three's, by properties that some of its classes have. */
type AnyMaterial = THREE.Material & { color?: THREE.Color; emissive?: THREE.Color };
/** A light that may cast shadows. */
export type Shadowed = THREE.PointLight | THREE.SpotLight | THREE.DirectionalLight;

/** Texture of 32 × 32 squares with mipmaps. */
function squares(size: number): THREE.DataTexture {
  const data = Uint8Array.from({ length: 4096 }, (_, i) =>
    i % 4 === 3 ? 255 : ((i >> 2) ^ (i >> 7)) & size ? 255 : 60,
  );
  const texture = new THREE.DataTexture(data, 32, 32);
  Object.assign(texture, {
    colorSpace: THREE.SRGBColorSpace,
    generateMipmaps: true,
    minFilter: THREE.LinearMipmapLinearFilter,
    magFilter: THREE.LinearFilter,
    wrapS: THREE.RepeatWrapping,
    wrapT: THREE.RepeatWrapping,
    needsUpdate: true,
  });
  return texture;
}

/** Two bones along x, shared by all skinned meshes of the scene. */
function skeletonOf(): THREE.Skeleton {
  const bones = [new THREE.Bone(), new THREE.Bone()];
  bones[0].add(bones[1]);
  bones[1].position.x = 0.4;
  bones[0].updateMatrixWorld(true);
  return new THREE.Skeleton(bones);
}

function skinnedBox(): THREE.BufferGeometry {
  const box = new THREE.BoxGeometry(1.6, 0.4, 0.4, 8, 1, 1);
  const { count } = box.attributes.position;
  const indices = new Uint16Array(count * 4);
  const weights = new Float32Array(count * 4);
  for (let i = 0; i < count; i++) {
    const weight = Math.min(1, Math.max(0, box.attributes.position.getX(i) + 0.5));
    indices.set([0, 1, 0, 0], i * 4);
    weights.set([1 - weight, weight, 0, 0], i * 4);
  }
  box.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(indices, 4));
  return box.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4));
}

function morphedBall(): THREE.BufferGeometry {
  const ball = new THREE.SphereGeometry(0.6, 20, 12);
  const long = ball.attributes.position.clone();
  for (let i = 0; i < long.count; i++) long.setY(i, long.getY(i) * 2);
  ball.morphAttributes.position = [long];
  return ball;
}

/** Whether the rasteriser draws an object's shadow twice alike: it does not with lines. */
export const castsAlike = (object: THREE.Object3D) => !('isLine' in object || 'isLine2' in object);

/** A scene that changes from frame to frame, as hosts change theirs: objects, lights and cameras, and all that these share. */
export class ChangingScene {
  readonly scene = new THREE.Scene();
  readonly cameras: (THREE.PerspectiveCamera | THREE.OrthographicCamera)[];
  camera: THREE.PerspectiveCamera | THREE.OrthographicCamera;
  readonly textures = [squares(4), squares(8)];
  readonly geometries: THREE.BufferGeometry[] = [
    new THREE.SphereGeometry(0.7, 24, 16),
    new THREE.BoxGeometry(1, 1, 1, 3, 3, 3),
    new THREE.TorusKnotGeometry(0.5, 0.2, 48, 8),
    new THREE.ConeGeometry(0.6, 1.2, 20),
  ];
  readonly materials: AnyMaterial[];
  readonly ground: THREE.Mesh;
  readonly things: THREE.Object3D[] = [];
  readonly lights: Record<'point' | 'spot' | 'sun', Shadowed[]> = { point: [], spot: [], sun: [] };
  readonly skeleton = skeletonOf();
  private readonly skinned = skinnedBox();
  private readonly morphed = morphedBall();
  /** Drawn before the scene, to the same target. */
  second: THREE.Scene | null = null;

  constructor(
    readonly bench: Bench,
    seed: number,
  ) {
    const dice = new Dice(seed);
    const { width, height } = bench;
    const side = (5 * height) / width;
    this.cameras = [
      new THREE.PerspectiveCamera(50, width / height, 0.1, 60),
      new THREE.PerspectiveCamera(30, width / height, 0.5, 100),
      new THREE.OrthographicCamera(-5, 5, side, -side, 0.1, 40),
    ];
    for (const [i, [x, y]] of [
      [0, 2],
      [6, 3],
      [-3, 4],
    ].entries()) {
      this.cameras[i].position.set(x, y, 8);
      this.cameras[i].lookAt(0, 0, 0);
    }
    this.camera = this.cameras[0];
    this.materials = [
      new THREE.MeshStandardMaterial({ color: 0xcc8844, roughness: 0.5 }),
      new THREE.MeshStandardMaterial({ color: 0x4488cc, roughness: 0.6, map: this.textures[0] }),
      new THREE.MeshLambertMaterial({ color: 0x88cc44 }),
      new THREE.MeshPhongMaterial({ color: 0xcccccc, specular: 0x222222 }),
      new THREE.MeshBasicMaterial({ color: 0x884422 }),
      new THREE.MeshStandardMaterial({ color: 0xff88ff, transparent: true, opacity: 0.5, side: THREE.DoubleSide }),
      new THREE.MeshPhysicalMaterial({ color: 0xddeeff, roughness: 0.4, clearcoat: 0.5 }),
    ];
    this.ground = new THREE.Mesh(
      new THREE.PlaneGeometry(14, 14, 6, 6),
      new THREE.MeshStandardMaterial({ color: 0x999999 }),
    );
    this.ground.rotation.x = -Math.PI / 2;
    this.ground.position.y = -1;
    this.ground.receiveShadow = true;
    this.scene.add(this.ground, new THREE.AmbientLight(0xffffff, 0.2), this.skeleton.bones[0]);
    for (let i = 0; i < 5; i++) this.addThing(dice);
    for (const kind of ['point', 'point', 'spot', 'sun'] as const) this.addLight(kind, dice);
    this.lights.spot[0].castShadow = true;
  }

  get allLights(): Shadowed[] {
    return Object.values(this.lights).flat();
  }

  get meshes(): THREE.Mesh[] {
    const found: THREE.Mesh[] = [];
    this.scene.traverse((object) => {
      if ((object as THREE.Mesh).isMesh) found.push(object as THREE.Mesh);
    });
    return found;
  }

  addLight(kind: 'point' | 'spot' | 'sun', dice: Dice, parent: THREE.Object3D = this.scene): Shadowed {
    const color = dice.of([0xff8844, 0xffffff, 0x44ff88]);
    const range = dice.of([0, 6, 12]);
    const light =
      kind === 'point'
        ? new THREE.PointLight(color, dice.between(5, 25), range)
        : kind === 'spot'
          ? new THREE.SpotLight(color, dice.between(20, 60), range, dice.between(0.3, 1), dice.between(0.1, 1))
          : new THREE.DirectionalLight(color, dice.between(0.3, 1.5));
    if (light instanceof THREE.SpotLight || light instanceof THREE.DirectionalLight) this.scene.add(light.target);
    light.position.set(dice.between(-4, 4), dice.between(1.5, 5), dice.between(-1, 5));
    light.shadow.mapSize.set(128, 128);
    light.shadow.bias = -0.01;
    this.lights[kind].push(light);
    parent.add(light);
    return light;
  }

  place(object: THREE.Object3D, dice: Dice): void {
    object.position.set(dice.between(-3, 3), dice.between(-0.7, 2), dice.between(-2, 2));
    object.rotation.set(dice.between(0, 6), dice.between(0, 6), dice.between(0, 6));
    object.castShadow = dice.in(0.6) && castsAlike(object);
    object.receiveShadow = dice.in(0.7);
  }

  addThing(dice: Dice): void {
    const object = this.makeThing(dice);
    this.place(object, dice);
    const { material } = object as { material?: AnyMaterial };
    // its geometry may lack normals, and three compiles `overrideMaterial` for the first geometry alone
    if (material && !this.materials.includes(material)) material.allowOverride = false;
    this.things.push(object);
    this.scene.add(object);
  }

  private makeThing(dice: Dice): THREE.Object3D {
    const { geometries, materials } = this;
    const mesh = () => new THREE.Mesh(dice.of(geometries), dice.of(materials));
    const small = () =>
      new THREE.Matrix4()
        .makeTranslation(dice.between(-2, 2), dice.between(-1, 1), dice.between(-2, 2))
        .scale(new THREE.Vector3(0.4, 0.4, 0.4));
    return dice.of<() => THREE.Object3D>([
      mesh,
      mesh,
      () => {
        const instanced = new THREE.InstancedMesh(dice.of(geometries), materials[0], 8);
        for (let i = 0; i < 8; i++) instanced.setMatrixAt(i, small());
        instanced.count = dice.whole(1, 8);
        return instanced;
      },
      () => {
        const batched = new THREE.BatchedMesh(8, 4000, 12000, materials[0]);
        const ids = [new THREE.BoxGeometry(), new THREE.ConeGeometry(0.6, 1.2)].map((one) => batched.addGeometry(one));
        batched.userData.geometries = ids;
        for (let i = 0; i < 5; i++) batched.setMatrixAt(batched.addInstance(dice.of(ids)), small());
        return batched;
      },
      () => {
        const levels = new THREE.LOD();
        levels.addLevel(mesh(), 0);
        levels.addLevel(mesh(), 8.3);
        for (const child of levels.children) child.castShadow = true;
        return levels;
      },
      () => {
        const group = new THREE.Group().add(mesh(), mesh());
        group.children[1].position.x = 1;
        for (const child of group.children) child.castShadow = child.receiveShadow = true;
        return group;
      },
      () =>
        new THREE.Mesh(
          geometries[1],
          [0, 1, 2, 0, 3, 1].map((i) => materials[i]),
        ),
      () => {
        const skinned = new THREE.SkinnedMesh(this.skinned, materials[0]);
        skinned.bind(this.skeleton, new THREE.Matrix4());
        return skinned;
      },
      () => {
        const morphed = new THREE.Mesh(this.morphed, materials[2]);
        morphed.morphTargetInfluences![0] = 0.5;
        return morphed;
      },
      () => {
        const sprite = new THREE.Sprite(
          new THREE.SpriteMaterial({ map: this.textures[1], sizeAttenuation: dice.in(0.5) }),
        );
        if (!sprite.material.sizeAttenuation) sprite.scale.setScalar(0.1);
        return sprite;
      },
      () => {
        const geometry = new THREE.SphereGeometry(0.8, 10, 8);
        const { count } = geometry.attributes.position;
        const colors = Float32Array.from({ length: count * 3 }, () => dice.next());
        geometry.setAttribute('color', new THREE.BufferAttribute(colors, 3));
        return new THREE.Points(
          geometry,
          new THREE.PointsMaterial({ size: dice.of([3, 0.15]), sizeAttenuation: dice.in(0.5), vertexColors: true }),
        );
      },
      () => {
        const geometry = new LineGeometry();
        geometry.setPositions(Array.from({ length: 18 }, () => dice.between(-1, 1)));
        return new Line2(geometry, new LineMaterial({ color: 0xffcc00, linewidth: 3 }));
      },
      () =>
        new THREE.LineSegments(
          new THREE.EdgesGeometry(dice.of(geometries)),
          new THREE.LineBasicMaterial({ color: 0xff0066 }),
        ),
    ])();
  }

  dispose(): void {
    for (const one of [...this.textures, ...this.geometries, ...this.materials]) one.dispose();
    for (const mesh of this.meshes) mesh.geometry.dispose();
    for (const light of this.allLights) light.dispose();
    this.skeleton.dispose();
  }
}
