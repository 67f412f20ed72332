import * as THREE from 'three';
import type { Cases } from './Case';

const { MeshStandardMaterial: Standard } = THREE;
const quad = new THREE.PlaneGeometry(0.9, 0.9);
const disc = new THREE.CircleGeometry(0.4, 20);
const ball = new THREE.SphereGeometry(0.4, 20, 14);

/** Things in a group, each at its depth (m) and with its render order. */
function stack(
  ...things: readonly [geometry: THREE.BufferGeometry, material: THREE.Material, z: number, order?: number][]
): THREE.Group {
  const group = new THREE.Group();
  things.forEach(([geometry, material, z, order = 0], i) => {
    const mesh = new THREE.Mesh(geometry, material);
    mesh.position.set((i - 0.5) * 0.2, (i - 0.5) * 0.15, z);
    mesh.renderOrder = order;
    group.add(mesh);
  });
  return group;
}
const lit = (color: number, more: THREE.MeshStandardMaterialParameters = {}) =>
  new Standard({ color, roughness: 0.5, ...more });

/** Materials whose picture depends on what is drawn before and after them. */
export const orderCases: Cases = {
  'hides by depth alone, first': () =>
    stack([disc, lit(0xffffff, { colorWrite: false }), 0.4, -1], [quad, lit(0xcc4444), 0]),
  'hides by depth alone, in between': () =>
    stack(
      [quad, lit(0x44cc44), 0, -1],
      [disc, lit(0xffffff, { colorWrite: false }), 0.3, 0],
      [ball, lit(0x4444cc), 0, 1],
    ),
  'does not write depth, first': () =>
    stack([disc, lit(0xcccc44, { depthWrite: false }), 0.4, -1], [quad, lit(0xcc4444), 0]),
  'does not test depth, first': () =>
    stack([disc, lit(0x44cccc, { depthTest: false }), 0.4, -1], [quad, lit(0xcc4444), 0]),
  'does not test depth, last': () =>
    stack([quad, lit(0xcc4444), 0.4], [disc, lit(0x44cccc, { depthTest: false }), 0, 5]),
  'unlit, does not test depth, first': () =>
    stack(
      [disc, new THREE.MeshBasicMaterial({ color: 0xff8800, depthTest: false, depthWrite: false }), 0.4, -2],
      [quad, lit(0x888888), 0],
    ),
  'drawn where it is farther': () =>
    stack([quad, lit(0xcc4444), 0.3], [disc, lit(0x44cc88, { depthFunc: THREE.GreaterDepth }), -0.2, 1]),
  'drawn at equal depth': () => {
    const group = stack([quad, lit(0x446688), 0], [quad, lit(0x886644, { depthFunc: THREE.EqualDepth }), 0, 1]);
    for (const child of group.children) child.position.set(0, 0, 0);
    return group;
  },
  'opaque, added to what is there': () =>
    stack([quad, lit(0x442222), 0], [disc, lit(0x224422, { blending: THREE.AdditiveBlending }), 0.2, 1]),
  'opaque without blending': () =>
    stack([quad, lit(0x442222), 0], [disc, lit(0x88cc88, { blending: THREE.NoBlending, opacity: 0.5 }), 0.2, 1]),
  'stencil: a hole that was cut before': () =>
    stack(
      [
        disc,
        lit(0xffffff, {
          colorWrite: false,
          depthWrite: false,
          stencilWrite: true,
          stencilRef: 1,
          stencilZPass: THREE.ReplaceStencilOp,
        }),
        0.5,
        -1,
      ],
      [quad, lit(0xcc8844, { stencilWrite: true, stencilRef: 1, stencilFunc: THREE.NotEqualStencilFunc }), 0.2],
      [ball, lit(0x4488cc), -0.3],
    ),
  'stencil: an outline afterwards': () => {
    const group = stack(
      [ball, lit(0x88aa44, { stencilWrite: true, stencilRef: 2, stencilZPass: THREE.ReplaceStencilOp }), 0],
      [
        ball,
        new THREE.MeshBasicMaterial({
          color: 0xffff00,
          stencilWrite: true,
          stencilRef: 2,
          stencilFunc: THREE.NotEqualStencilFunc,
          depthTest: false,
        }),
        0,
        2,
      ],
    );
    for (const child of group.children) child.position.set(0, 0, 0);
    group.children[1].scale.setScalar(1.15);
    return group;
  },
  'transparent things by render order': () =>
    stack(
      [quad, lit(0xcc4444, { transparent: true, opacity: 0.5 }), 0.3, 1],
      [disc, lit(0x44cc44, { transparent: true, opacity: 0.5 }), 0, 2],
      [ball, lit(0x4444cc, { transparent: true, opacity: 0.5, depthWrite: false }), -0.2, 0],
    ),
  'groups that say their order': () => {
    const outer = new THREE.Group();
    for (const [order, color] of [
      [2, 0xcc8888],
      [1, 0x8888cc],
    ]) {
      const group = stack([quad, lit(color, { transparent: true, opacity: 0.6, depthTest: false }), 0]);
      group.renderOrder = order;
      group.position.set(order * 0.2 - 0.3, 0, 0);
      outer.add(group);
    }
    return outer;
  },
};
