import * as THREE from 'three';
import { castsAlike, type ChangingScene } from './ChangingScene';
import type { Dice } from './Dice';
import { type Change, lightChanges } from './lightChanges';

const meshOf = ({ meshes }: ChangingScene, dice: Dice) => dice.of(meshes);
const instancedOf = ({ meshes }: ChangingScene) =>
  meshes.find((one): one is THREE.InstancedMesh => (one as THREE.InstancedMesh).isInstancedMesh);
const batchedOf = ({ meshes }: ChangingScene) =>
  meshes.find((one): one is THREE.BatchedMesh => (one as THREE.BatchedMesh).isBatchedMesh);
/** One of the materials by their numbers in `ChangingScene.materials`. */
const materialOf = ({ materials }: ChangingScene, dice: Dice, ...of: number[]) =>
  of.length > 0 ? materials[dice.of(of)] : dice.of(materials);
const isPlain = (mesh: THREE.Mesh) =>
  !Array.isArray(mesh.material) &&
  !(mesh as THREE.BatchedMesh).isBatchedMesh &&
  !(mesh as THREE.SkinnedMesh).isSkinnedMesh &&
  !(mesh as THREE.Mesh & { isLine2?: boolean }).isLine2 &&
  !mesh.morphTargetInfluences;

const objects: Record<string, Change> = {
  moveThing: (w, d) => w.place(d.of(w.things), d),
  addThing: (w, d) => {
    if (w.things.length < 8) w.addThing(d);
  },
  removeThing: (w, d) => {
    if (w.things.length > 3) w.things.splice(d.whole(0, w.things.length - 1), 1)[0].removeFromParent();
  },
  meshVisible: (w, d) => {
    const mesh = meshOf(w, d);
    mesh.visible = !mesh.visible;
  },
  thingVisible: (w, d) => {
    const thing = d.of(w.things);
    thing.visible = !thing.visible;
  },
  layers: (w, d) => {
    meshOf(w, d).layers.set(d.of([0, 0, 0, 1]));
    w.camera.layers.enable(d.of([0, 1]));
  },
  castShadow: (w, d) => {
    const mesh = meshOf(w, d);
    if (castsAlike(mesh)) mesh.castShadow = !mesh.castShadow;
  },
  receiveShadow: (w, d) => {
    const mesh = meshOf(w, d);
    mesh.receiveShadow = !mesh.receiveShadow;
  },
  material: (w, d) => {
    const mesh = meshOf(w, d);
    if (isPlain(mesh) && mesh !== w.ground) mesh.material = d.of(w.materials);
  },
  materialList: (w, d) => {
    const mesh = w.meshes.find(({ material }) => Array.isArray(material));
    if (mesh) (mesh.material as THREE.Material[])[d.whole(0, 5)] = d.of(w.materials);
  },
  groups: (w) => {
    const mesh = w.meshes.find(({ material }) => Array.isArray(material));
    mesh?.geometry.groups.reverse();
  },
  geometry: (w, d) => {
    const mesh = meshOf(w, d);
    if (isPlain(mesh) && mesh !== w.ground) mesh.geometry = d.of(w.geometries);
  },
  negativeScale: (w, d) => void d.of(w.things).scale.set(d.of([1, -1]), d.of([1, -1, 0.5]), 1),
  zeroScale: (w, d) => void d.of(w.things).scale.setScalar(d.of([0, 1, 1, 1e-6])),
  matrixAutoUpdate: (w, d) => {
    const thing = d.of(w.things);
    thing.matrixAutoUpdate = !thing.matrixAutoUpdate;
    thing.position.x += 0.2;
  },
  matrixWorldAutoUpdate: (w, d) => {
    const thing = d.of(w.things);
    thing.matrixWorldAutoUpdate = !thing.matrixWorldAutoUpdate;
    thing.position.x += 0.2;
  },
  renderOrder: (w, d) => void (meshOf(w, d).renderOrder = d.of([-1, 0, 0, 1])),
  frustumCulled: (w, d) => void (meshOf(w, d).frustumCulled = d.in(0.5)),
  reparent: (w, d) => {
    const thing = d.of(w.things);
    const other = d.of(w.things);
    if (thing !== other && !other.getObjectById(thing.id) && !thing.getObjectById(other.id)) other.attach(thing);
  },
  instanceCount: (w, d) => {
    const mesh = instancedOf(w);
    if (mesh) mesh.count = d.whole(0, 8);
  },
  instanceMatrix: (w, d) => {
    const mesh = instancedOf(w);
    mesh?.setMatrixAt(0, new THREE.Matrix4().makeTranslation(d.between(-2, 2), 0, 0));
    if (mesh && d.in(0.5)) mesh.instanceMatrix.addUpdateRange(0, 16);
    if (mesh) mesh.instanceMatrix.needsUpdate = true;
    mesh?.computeBoundingSphere();
  },
  instanceColor: (w, d) => {
    const mesh = instancedOf(w);
    if (!mesh) return;
    for (let i = 0; i < 8; i++) mesh.setColorAt(i, new THREE.Color().setHSL(d.next(), 0.7, 0.6));
    mesh.instanceColor!.needsUpdate = true;
  },
  batch: (w, d) => {
    const mesh = batchedOf(w);
    if (!mesh) return;
    const matrix = new THREE.Matrix4().makeTranslation(d.between(-1, 1), d.between(-1, 1), 1);
    const id = d.whole(0, 4);
    try {
      d.one([
        () => mesh.deleteInstance(id),
        () => mesh.setMatrixAt(mesh.addInstance(d.of(mesh.userData.geometries)), matrix),
        () => mesh.setVisibleAt(id, d.in(0.5)),
        () => mesh.setColorAt(id, new THREE.Color(d.next(), d.next(), d.next())),
        () => mesh.setGeometryIdAt(id, d.of(mesh.userData.geometries)),
        () => void (mesh.perObjectFrustumCulled = !mesh.perObjectFrustumCulled),
        () => void (mesh.sortObjects = !mesh.sortObjects),
        () => mesh.optimize(),
      ]);
    } catch {} // the instance was deleted before
  },
  bone: (w, d) => void w.skeleton.bones[1].rotation.set(0, 0, d.between(-1, 1)),
  morph: (w, d) => {
    for (const mesh of w.meshes) if (mesh.morphTargetInfluences?.length) mesh.morphTargetInfluences[0] = d.next();
  },
  onBeforeRender: (w, d) => void (meshOf(w, d).onBeforeRender = () => {}),
  depthMaterial: (w, d) => {
    const mesh = meshOf(w, d);
    mesh.customDepthMaterial = mesh.customDepthMaterial
      ? undefined
      : new THREE.MeshDepthMaterial({ depthPacking: THREE.RGBADepthPacking });
  },
};

const materials: Record<string, Change> = {
  color: (w, d) => void materialOf(w, d).color!.setHSL(d.next(), 0.6, 0.5),
  roughness: (w, d) => void Object.assign(materialOf(w, d, 0, 1, 6), { roughness: d.next(), metalness: d.of([0, 1]) }),
  side: (w, d) => void (materialOf(w, d, 0, 2).side = d.of([0, 1, 2] as const)),
  shadowSide: (w, d) => void (materialOf(w, d, 0, 2).shadowSide = d.of([null, 0, 1, 2] as const)),
  transparent: (w, d) => {
    const material = materialOf(w, d, 0, 3);
    Object.assign(material, { transparent: !material.transparent, opacity: d.of([0.4, 1]), needsUpdate: true });
  },
  blending: (w, d) =>
    void (materialOf(w, d, 5).blending = d.of([
      THREE.NormalBlending,
      THREE.AdditiveBlending,
      THREE.MultiplyBlending,
      THREE.NoBlending,
    ])),
  forceSinglePass: (w, d) => void (materialOf(w, d, 5).forceSinglePass = d.in(0.5)),
  depth: (w, d) => void Object.assign(materialOf(w, d), { depthWrite: d.in(0.7), depthTest: d.in(0.8) }),
  map: (w, d) => void Object.assign(w.materials[1], { map: d.of([...w.textures, null]), needsUpdate: true }),
  emissive: (w, d) => void materialOf(w, d, 0, 1, 2, 6).emissive!.setHSL(d.next(), 0.5, d.between(0, 0.3)),
  emissiveMap: (w, d) =>
    void Object.assign(w.materials[1], { emissiveMap: d.of([w.textures[1], null]), needsUpdate: true }),
  flatShading: (w) => {
    const material = w.materials[0] as THREE.MeshStandardMaterial;
    Object.assign(material, { flatShading: !material.flatShading, needsUpdate: true });
  },
  materialVisible: (w, d) => {
    const material = materialOf(w, d);
    material.visible = !material.visible;
  },
  colorWrite: (w, d) => void (materialOf(w, d).colorWrite = d.in(0.8)),
  alphaTest: (w, d) => void Object.assign(w.materials[1], { alphaTest: d.of([0, 0.5]), needsUpdate: true }),
  alphaHash: (w, d) => void Object.assign(w.materials[2], { alphaHash: d.in(0.3), needsUpdate: true }),
  physical: (w, d) =>
    void Object.assign(w.materials[6], {
      [d.of(['clearcoat', 'sheen', 'iridescence', 'transmission', 'anisotropy', 'dispersion'])]: d.of([0, 0.6]),
    }),
  specular: (w, d) => void Object.assign(w.materials[6], { specularIntensity: d.next(), ior: d.between(1, 2.3) }),
  phong: (w, d) => void Object.assign(w.materials[3], { shininess: d.between(1, 90) }),
  fogOfBasic: (w, d) => void Object.assign(w.materials[4], { fog: d.in(0.7), needsUpdate: true }),
  fogOfMaterial: (w, d) => void Object.assign(materialOf(w, d), { fog: d.in(0.7), needsUpdate: true }),
  toneMapped: (w, d) => void Object.assign(materialOf(w, d), { toneMapped: d.in(0.5), needsUpdate: true }),
  onBeforeCompile: (w, d) =>
    void Object.assign(materialOf(w, d, 0, 2), {
      onBeforeCompile: d.of([
        (shader: { fragmentShader: string }) => {
          shader.fragmentShader = shader.fragmentShader.replace(
            '#include <color_fragment>',
            '#include <color_fragment>\ndiffuseColor.rgb *= vec3(0.3, 1.0, 0.3);',
          );
        },
        () => {},
      ]),
      needsUpdate: true,
    }),
  cacheKey: (w, d) => {
    const key = d.of(['one', 'two']);
    Object.assign(materialOf(w, d, 0, 3), { customProgramCacheKey: () => key, needsUpdate: true });
  },
  defines: (w, d) =>
    void Object.assign(materialOf(w, d, 0, 2), { defines: { HOST: d.whole(1, 2) }, needsUpdate: true }),
  polygonOffset: (w, d) => void Object.assign(materialOf(w, d), { polygonOffset: d.in(0.5), polygonOffsetFactor: 2 }),
  materialClipping: (w, d) =>
    void Object.assign(materialOf(w, d, 0, 2), {
      clippingPlanes: d.of([
        null,
        [new THREE.Plane(new THREE.Vector3(0, -1, 0), d.next())],
        [new THREE.Plane(new THREE.Vector3(0, -1, 0), 0.2), new THREE.Plane(new THREE.Vector3(1, 0, 0), 0.1)],
      ]),
      clipIntersection: d.in(0.5),
      clipShadows: d.in(0.5),
    }),
  disposeMaterial: (w, d) => materialOf(w, d).dispose(),
  version: (w, d) => void (materialOf(w, d).needsUpdate = true),
  envMap: (w, d) =>
    void Object.assign(materialOf(w, d, 0, 1), {
      envMap: d.in(0.5) ? w.bench.environment() : null,
      envMapIntensity: 0.7,
    }),
  vertexColors: (w, d) => {
    const geometry = d.of(w.geometries);
    const { count } = geometry.attributes.position;
    geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(count * 3).fill(d.next()), 3));
    Object.assign(w.materials[2], { vertexColors: d.in(0.5), needsUpdate: true });
  },
};

const data: Record<string, Change> = {
  disposeGeometry: (w, d) => d.of(w.geometries).dispose(),
  disposeTexture: (w, d) => d.of(w.textures).dispose(),
  textureData: (w, d) => {
    const texture = d.of(w.textures);
    (texture.image.data as Uint8Array).fill(d.whole(0, 254), 0, 1000);
    texture.needsUpdate = true;
  },
  textureMatrix: (w, d) => {
    const texture = d.of(w.textures);
    texture.repeat.set(d.of([1, 2, 3]), 1);
    texture.rotation = d.next();
  },
  positions: (w, d) => {
    const geometry = d.of(w.geometries);
    const { position } = geometry.attributes;
    for (let i = 0; i < position.count; i++) position.setX(i, position.getX(i) * 1.05);
    position.needsUpdate = true;
    if (d.in(0.5)) geometry.computeBoundingSphere();
  },
  updateRange: (w, d) => {
    const { position } = d.of(w.geometries).attributes;
    if (!(position instanceof THREE.BufferAttribute)) return;
    for (let i = 0; i < 12; i++) position.setY(i, position.getY(i) + 0.1);
    position.addUpdateRange(0, 36);
    position.needsUpdate = true;
  },
  drawRange: (w, d) => d.of(w.geometries).setDrawRange(d.of([0, 30]), d.of([Infinity, 60, 0])),
  attribute: (w, d) => {
    const geometry = d.of(w.geometries);
    geometry.setAttribute('position', geometry.attributes.position.clone());
  },
  interleaved: (w, d) => {
    const geometry = d.of(w.geometries);
    const { position, normal } = geometry.attributes;
    const values = new Float32Array(position.count * 6);
    for (let i = 0; i < position.count; i++)
      values.set(
        [position, normal].flatMap((one) => [one.getX(i), one.getY(i), one.getZ(i)]),
        i * 6,
      );
    const buffer = new THREE.InterleavedBuffer(values, 6);
    geometry.setAttribute('position', new THREE.InterleavedBufferAttribute(buffer, 3, 0));
    geometry.setAttribute('normal', new THREE.InterleavedBufferAttribute(buffer, 3, 3));
  },
  index: (w, d) => {
    const geometry = d.of(w.geometries);
    if (geometry.index) geometry.setIndex(new THREE.Uint32BufferAttribute(geometry.index.array, 1));
  },
};

const world: Record<string, Change> = {
  camera: (w, d) => void (w.camera = d.of(w.cameras)),
  moveCamera: (w, d) => {
    w.camera.position.x += d.between(-1, 1);
    w.camera.lookAt(0, 0, 0);
  },
  zoom: (w, d) => {
    if (w.camera instanceof THREE.PerspectiveCamera) w.camera.fov = d.of([20, 50, 100]);
    else w.camera.zoom = d.of([0.5, 1, 2]);
    w.camera.updateProjectionMatrix();
  },
  planes: (w, d) => {
    Object.assign(w.camera, { near: d.of([0.01, 0.1, 3]), far: d.of([12, 60, 1000]) });
    w.camera.updateProjectionMatrix();
  },
  cameraIntoThing: (w, d) => {
    if (w.camera.parent) w.camera.removeFromParent();
    else d.of([w.scene, w.ground]).attach(w.camera);
  },
  cameraAlone: (w, d) => {
    w.camera.matrixWorldAutoUpdate = d.in(0.6);
    w.camera.position.y += 0.1;
  },
  viewOffset: (w, d) => {
    const { width, height } = w.bench;
    if (d.in(0.5)) w.camera.setViewOffset(width * 2, height * 2, d.whole(0, width), d.whole(0, height), width, height);
    else w.camera.clearViewOffset();
  },
  fog: (w, d) => void (w.scene.fog = d.of([null, new THREE.Fog(0x8899aa, 3, 14), new THREE.FogExp2(0x8899aa, 0.08)])),
  background: (w, d) => {
    w.scene.background = d.of([null, new THREE.Color(0x223344), w.textures[0], w.bench.environment()]);
    w.scene.backgroundBlurriness = d.of([0, 0.4]);
  },
  environment: (w, d) => {
    w.scene.environment = d.of([null, w.bench.environment(), new THREE.Texture()]);
    w.scene.environmentIntensity = d.next();
    w.scene.environmentRotation.y = d.between(0, 6);
  },
  clipping: (w, d) =>
    void (w.bench.webgl.clippingPlanes = d.of([[], [new THREE.Plane(new THREE.Vector3(1, 0, 0), d.between(0, 2))]])),
  localClipping: (w, d) => void (w.bench.webgl.localClippingEnabled = d.in(0.7)),
  override: (w, d) => void (w.scene.overrideMaterial = d.of([null, null, w.materials[2], w.materials[0]])),
  sortObjects: (w, d) => void (w.bench.webgl.sortObjects = d.in(0.7)),
  sceneUpdates: (w, d) => void (w.scene.matrixWorldAutoUpdate = d.in(0.6)),
  pixelRatio: (w, d) => w.bench.webgl.setPixelRatio(d.of([1, 2, 0.5])),
  toneMapping: (w, d) =>
    void Object.assign(w.bench.webgl, {
      toneMapping: d.of([THREE.NoToneMapping, THREE.ACESFilmicToneMapping, THREE.AgXToneMapping]),
      toneMappingExposure: d.between(0.5, 1.5),
    }),
  outputColors: (w, d) =>
    void (w.bench.webgl.outputColorSpace = d.of([THREE.SRGBColorSpace, THREE.LinearSRGBColorSpace])),
  clearColor: (w, d) => w.bench.webgl.setClearColor(d.color(), d.of([0, 0.5, 1])),
  autoClear: (w, d) => void (w.bench.webgl.autoClear = d.in(0.6)),
  second: (w, d) => {
    const ball = new THREE.Mesh(w.geometries[0], w.materials[4]);
    ball.position.set(-1.5, 0.5, 1);
    w.second = d.in(0.5) ? (new THREE.Scene().add(ball, new THREE.PointLight(0xffffff, 10)) as THREE.Scene) : null;
  },
  probe: (w, d) => {
    const probe = w.scene.getObjectByName('probe');
    if (probe) return void probe.removeFromParent();
    const made = new THREE.LightProbe();
    made.name = 'probe';
    made.sh.coefficients[0].set(d.next(), d.next(), d.next());
    w.scene.add(made);
  },
  hemisphere: (w, d) => void w.scene.add(new THREE.HemisphereLight(d.color(), d.color(), 0.1)),
  viewport: (w, d) => {
    const { target, width, height } = w.bench;
    if (d.in(0.5)) target.viewport.set(0, 0, width, height);
    else target.viewport.set(d.whole(0, 20), d.whole(0, 20), d.whole(20, width), d.whole(20, height));
    target.scissorTest = d.in(0.4);
    target.scissor.set(10, 10, d.whole(20, width), d.whole(20, height));
  },
  compile: (w) => void w.bench.webgl.compile(w.scene, w.camera),
};

/** Changes of a scene and its host that code of pages makes between frames, by name. */
export const changes: Readonly<Record<string, Change>> = {
  ...lightChanges,
  ...objects,
  ...materials,
  ...data,
  ...world,
};
