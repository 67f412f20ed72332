import * as THREE from 'three';
import { RectAreaLightUniformsLib } from 'three/addons/lights/RectAreaLightUniformsLib.js';
import { RectAreaLightTexturesLib } from 'three/addons/lights/RectAreaLightTexturesLib.js';
import { WebGLNodesHandler } from 'three/addons/tsl/WebGLNodesHandler.js';
import {
  cameraPosition,
  color,
  float,
  mix,
  normalLocal,
  normalView,
  positionLocal,
  positionWorld,
  sin,
  texture,
  time,
  uv,
  vec3,
} from 'three/tsl';
import * as nodes from 'three/webgpu';
import { batched, instanced, morphed, skinned } from './materialScene';
import { colourMap, normalMap } from './matrix/textures';

const ball = () => new THREE.SphereGeometry(0.6, 24, 16);
const on = (material: THREE.Material, geometry: THREE.BufferGeometry = ball()) => new THREE.Mesh(geometry, material);
const small = <T extends THREE.Object3D>(object: T, scale = 0.6): T => {
  object.scale.setScalar(scale);
  return object;
};

function standard(
  parameters: nodes.MeshStandardNodeMaterialParameters = {},
  change?: (material: nodes.MeshStandardNodeMaterial) => void,
) {
  const material = new nodes.MeshStandardNodeMaterial({ roughness: 0.4, color: 0xccddee, ...parameters });
  change?.(material);
  return material;
}

/** Node materials of each kind, on each kind of object. */
export const nodeCases: Record<string, () => THREE.Object3D> = {
  standard: () => on(standard()),
  'colour and normal nodes': () =>
    on(
      standard({}, (m) => {
        m.colorNode = mix(color(0xff4422), color(0x2244ff), uv().x);
        m.normalNode = normalView.add(vec3(sin(positionLocal.x.mul(20)).mul(0.2), 0, 0)).normalize();
      }),
    ),
  'emissive, roughness and metalness nodes': () =>
    on(
      standard({}, (m) => {
        m.emissiveNode = vec3(uv().y.mul(0.4), 0, 0.1);
        m.roughnessNode = uv().x;
        m.metalnessNode = float(0.5);
      }),
    ),
  'time, world position': () =>
    on(
      standard({}, (m) => {
        m.colorNode = vec3(
          sin(time.mul(0)).add(0.5),
          positionWorld.y.mul(0.1).add(0.5),
          cameraPosition.x.mul(0).add(0.3),
        );
      }),
    ),
  'position node': () =>
    on(
      standard({}, (m) => {
        m.positionNode = positionLocal.add(normalLocal.mul(sin(positionLocal.y.mul(9)).mul(0.1)));
      }),
    ),
  maps: () => on(standard({ map: colourMap(), normalMap: normalMap() })),
  'texture node': () =>
    on(
      standard({}, (m) => {
        m.colorNode = texture(colourMap());
      }),
    ),
  phong: () => on(new nodes.MeshPhongNodeMaterial({ color: 0x88ccff })),
  lambert: () => on(new nodes.MeshLambertNodeMaterial({ color: 0x88ffcc })),
  toon: () => on(new nodes.MeshToonNodeMaterial({ color: 0xffcc88 })),
  basic: () => on(new nodes.MeshBasicNodeMaterial({ color: 0xcc88ff })),
  normal: () => on(new nodes.MeshNormalNodeMaterial()),
  matcap: () => on(new nodes.MeshMatcapNodeMaterial({ color: 0xccff88 })),
  clearcoat: () => on(new nodes.MeshPhysicalNodeMaterial({ clearcoat: 1, roughness: 0.2 })),
  'alpha test': () => on(standard({ map: colourMap(), alphaTest: 0.5 })),
  'alpha test node': () =>
    on(
      standard({}, (m) => {
        m.opacityNode = uv().x;
        m.alphaTestNode = float(0.4);
      }),
    ),
  mask: () =>
    on(
      standard({}, (m) => {
        m.maskNode = uv().x.greaterThan(0.4);
      }),
    ),
  'both sides': () =>
    on(
      standard({ side: THREE.DoubleSide }, (m) => {
        m.maskNode = uv().y.greaterThan(0.5);
      }),
    ),
  transparent: () => on(standard({ transparent: true, opacity: 0.5 })),
  'transparent, both sides': () => on(standard({ transparent: true, opacity: 0.5, side: THREE.DoubleSide })),
  additive: () => on(standard({ transparent: true, opacity: 0.5, blending: THREE.AdditiveBlending })),
  wireframe: () => on(standard({ wireframe: true })),
  'no depth test': () => on(standard({ depthTest: false })),
  instanced: () => small(instanced(standard())),
  skinned: () => small(skinned(standard())),
  morphed: () => small(morphed(standard())),
  batched: () => small(batched(standard())),
  clipped: () => on(standard({ clippingPlanes: [new THREE.Plane(new THREE.Vector3(0, 0.6, 0.8), 0.1)] })),
  sprite: () => new THREE.Sprite(new nodes.SpriteNodeMaterial({ color: 0x44ff88 }) as never),
  points: () => new THREE.Points(ball(), new nodes.PointsNodeMaterial({ color: 0xffffff, size: 3 }) as never),
  line: () => new THREE.Line(ball(), new nodes.LineBasicNodeMaterial({ color: 0xffaa00 })),
  'with callbacks': () => {
    const mesh = on(standard());
    mesh.onBeforeRender = () => undefined;
    mesh.renderOrder = 1;
    return mesh;
  },
  'cast and received shadow nodes': () =>
    on(
      standard({}, (m) => {
        m.castShadowNode = color(0xff0000);
        m.receivedShadowNode = ((shadow: nodes.Node) => vec3(shadow as never).mul(0.5)) as never;
      }),
    ),
  'cast shadow position node': () =>
    on(
      standard({}, (m) => {
        m.castShadowPositionNode = positionLocal.mul(1.5);
      }),
    ),
  'vertex and fragment nodes': () =>
    on(
      Object.assign(new nodes.MeshBasicNodeMaterial(), {
        fragmentNode: vec3(uv(), 0.5),
      }),
    ),
  'output node': () =>
    on(
      standard({}, (m) => {
        m.outputNode = vec3(uv(), 0.2);
      }),
    ),
  'environment node': () =>
    on(
      standard({}, (m) => {
        m.envNode = color(0x4466aa);
        m.aoNode = float(0.5);
      }),
    ),
  'shadow material': () => on(new nodes.ShadowNodeMaterial({ opacity: 0.5, transparent: true } as never)),
  'dashed line': () => {
    const material = new nodes.LineDashedNodeMaterial({ color: 0xffaa00, dashSize: 0.1, gapSize: 0.1 });
    return new THREE.Line(ball().toNonIndexed(), material).computeLineDistances();
  },
  stencil: () => on(standard({ stencilWrite: true })),
  'colours of vertices': () => small(morphed(standard({ vertexColors: true }))),
  'half transparent, alpha hash': () => on(standard({ alphaHash: true, opacity: 0.5 })),
  'glass of three': () => on(new THREE.MeshPhysicalMaterial({ transmission: 1, roughness: 0.2 })),
};

/** Glass of nodes, which three's WebGLRenderer does not draw rightly itself. */
export const nodeGlass = () => on(new nodes.MeshPhysicalNodeMaterial({ roughness: 0.2, transmission: 1 }));

/** One case before a wall and over a floor of nodes, under lights of each kind, with shadows, in fog. */
export function nodeCase(thing: THREE.Object3D, width: number, height: number) {
  const scene = new THREE.Scene();
  scene.fog = new THREE.Fog(0x668899, 3, 9);
  const camera = new THREE.PerspectiveCamera(40, width / height, 0.1, 30);
  camera.position.set(0.3, 0.6, 3.4);
  camera.lookAt(0, 0, 0);
  const wall = on(new THREE.MeshStandardMaterial({ color: 0x999999 }), new THREE.PlaneGeometry(8, 6));
  wall.position.z = -1.2;
  const floor = on(standard({ color: 0x88aa88 }), new THREE.PlaneGeometry(8, 6));
  floor.position.y = -0.7;
  floor.rotation.x = -Math.PI / 2;
  const box = on(new THREE.MeshStandardMaterial({ color: 0x55ff99 }), new THREE.BoxGeometry(0.5, 0.5, 0.5));
  box.position.set(0.5, -0.3, 0.4);
  for (const one of [thing, wall, floor, box]) one.castShadow = one.receiveShadow = true;
  const sun = new THREE.DirectionalLight(0xffffff, 1);
  sun.position.set(-1, 2, 2);
  sun.castShadow = true;
  const lamp = new THREE.PointLight(0xff8844, 10, 9);
  lamp.position.set(1.5, 1, 2);
  const spot = new THREE.SpotLight(0x88aaff, 30, 12, 0.5, 0.5);
  spot.position.set(1, 3, 2);
  spot.castShadow = true;
  const panel = new THREE.RectAreaLight(0xffffff, 4, 1, 1);
  panel.position.set(0, 1, 2);
  panel.lookAt(0, 0, 0);
  scene.add(panel, thing, wall, floor, box, sun, lamp, spot, spot.target, new THREE.AmbientLight(0xffffff, 0.3));
  return { scene, camera };
}

/** three's handler, by which a renderer draws node materials. */
export function nodesHandler() {
  RectAreaLightUniformsLib.init();
  nodes.RectAreaLightNode.setLTC(RectAreaLightTexturesLib.init());
  return new WebGLNodesHandler() as never;
}
