import * as THREE from 'three';
import { batched, instanced, morphed, skinned } from '../materialScene';
import type { Cases } from './Case';

const { MeshStandardMaterial: Standard } = THREE;
const lit = () => new Standard({ color: 0xbbccdd, roughness: 0.45 });
const small = <T extends THREE.Object3D>(object: T, scale = 0.7): T => {
  object.scale.setScalar(scale);
  return object;
};
const knot = () => new THREE.TorusKnotGeometry(0.4, 0.15, 48, 8);

function interleaved(): THREE.BufferGeometry {
  const source = knot();
  const { position, normal } = source.attributes;
  const data = new THREE.InterleavedBuffer(new Float32Array(position.count * 6), 6);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.InterleavedBufferAttribute(data, 3, 0));
  geometry.setAttribute('normal', new THREE.InterleavedBufferAttribute(data, 3, 3));
  for (let i = 0; i < position.count; i++) {
    geometry.attributes.position.setXYZ(i, position.getX(i), position.getY(i), position.getZ(i));
    geometry.attributes.normal.setXYZ(i, normal.getX(i), normal.getY(i), normal.getZ(i));
  }
  geometry.setIndex(source.index);
  return geometry;
}

function wide(): THREE.BufferGeometry {
  const geometry = knot();
  geometry.setIndex(new THREE.Uint32BufferAttribute(Array.from(geometry.index!.array), 1));
  return geometry;
}

function quantised(): THREE.BufferGeometry {
  const geometry = knot();
  const { normal } = geometry.attributes;
  const bytes = Int8Array.from(normal.array, (value) => Math.round(value * 127));
  geometry.setAttribute('normal', new THREE.BufferAttribute(bytes, 3, true));
  return geometry;
}

function ofMaterials(): THREE.Mesh {
  const mesh = new THREE.Mesh(new THREE.BoxGeometry(0.9, 0.9, 0.9), [
    new Standard({ color: 0xff8888, roughness: 0.5 }),
    new THREE.MeshLambertMaterial({ color: 0x88ff88 }),
    new THREE.MeshPhongMaterial({ color: 0x8888ff }),
    new THREE.MeshBasicMaterial({ color: 0xffff88 }),
    new THREE.MeshToonMaterial({ color: 0x88ffff }),
    new Standard({ color: 0xff88ff, transparent: true, opacity: 0.5 }),
  ]);
  mesh.rotation.set(0.6, 0.6, 0.2);
  return mesh;
}

function level(): THREE.LOD {
  const lod = new THREE.LOD();
  lod.addLevel(new THREE.Mesh(new THREE.IcosahedronGeometry(0.6, 3), lit()), 0);
  lod.addLevel(new THREE.Mesh(new THREE.IcosahedronGeometry(0.6, 0), new Standard({ flatShading: true })), 5);
  return lod;
}

function morphedInstances(): THREE.InstancedMesh {
  const geometry = new THREE.BoxGeometry(0.3, 0.3, 0.3);
  const { position } = geometry.attributes;
  geometry.morphAttributes.position = [
    new THREE.Float32BufferAttribute(
      Array.from(position.array, (value, i) => value * (1 + (i % 5) * 0.2)),
      3,
    ),
  ];
  const mesh = new THREE.InstancedMesh(geometry, lit(), 4);
  const shape = new THREE.Mesh(geometry, lit());
  for (let i = 0; i < 4; i++) {
    mesh.setMatrixAt(i, new THREE.Matrix4().makeTranslation((i % 2) * 0.6 - 0.3, Math.floor(i / 2) * 0.6 - 0.3, 0));
    mesh.setColorAt(i, new THREE.Color().setHSL(i / 4, 0.8, 0.5));
    shape.morphTargetInfluences = [i / 4];
    mesh.setMorphAt(i, shape);
  }
  mesh.morphTexture!.needsUpdate = true;
  return mesh;
}

function hardwareInstances(): THREE.Mesh {
  const geometry = new THREE.InstancedBufferGeometry();
  const source = new THREE.BoxGeometry(0.25, 0.25, 0.25);
  geometry.setIndex(source.index);
  for (const name of ['position', 'normal', 'uv']) geometry.setAttribute(name, source.attributes[name]);
  geometry.setAttribute(
    'shift',
    new THREE.InstancedBufferAttribute(new Float32Array([-0.4, 0, 0, 0.4, 0.2, 0, 0, -0.4, 0.2]), 3),
  );
  const material = lit();
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = `attribute vec3 shift;\n${shader.vertexShader.replace('#include <begin_vertex>', '#include <begin_vertex>\ntransformed += shift;')}`;
  };
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

/** Every kind of geometry of three, and objects with groups of materials, levels of detail, layers, callbacks. */
export const geometryCases: Cases = {
  skinned: () => small(skinned(new Standard({ color: 0xdddddd, roughness: 0.35 })), 0.6),
  'skinned, transparent': () => small(skinned(new THREE.MeshPhongMaterial({ transparent: true, opacity: 0.6 })), 0.6),
  morphed: () => small(morphed(new Standard({ vertexColors: true, roughness: 0.5 }))),
  'morphed, lambert': () => small(morphed(new THREE.MeshLambertMaterial())),
  'instanced, coloured': () => small(instanced(lit())),
  'instanced, of the user': hardwareInstances,
  'instanced, morphed': morphedInstances,
  batched: () => small(batched(new Standard({ roughness: 0.45 }))),
  'batched, toon': () => small(batched(new THREE.MeshToonMaterial())),
  'not indexed': () => new THREE.Mesh(knot().toNonIndexed(), lit()),
  interleaved: () => new THREE.Mesh(interleaved(), lit()),
  '32-bit indices': () => new THREE.Mesh(wide(), lit()),
  'normals of bytes': () => new THREE.Mesh(quantised(), lit()),
  'no normals, flat shading': () => {
    const geometry = knot();
    geometry.deleteAttribute('normal');
    return new THREE.Mesh(geometry, new Standard({ flatShading: true, roughness: 0.5 }));
  },
  'draw range': () => {
    const geometry = knot();
    geometry.setDrawRange(150, 900);
    return new THREE.Mesh(geometry, lit());
  },
  'groups of several materials': ofMaterials,
  'level of detail': level,
  'not culled': () => {
    const mesh = new THREE.Mesh(knot(), lit());
    mesh.frustumCulled = false;
    return mesh;
  },
  'sprites in a group that is scaled unevenly': () => {
    const group = new THREE.Group();
    group.scale.set(0.8, 0.5, 1);
    group.add(new THREE.Sprite(new THREE.SpriteMaterial({ color: 0x44ff88 })));
    group.add(new THREE.Mesh(knot(), lit()));
    return group;
  },
  'layers that the camera does not see': () => {
    const mesh = new THREE.Mesh(knot(), lit());
    mesh.layers.set(5);
    return mesh;
  },
  'uniforms set before each draw': () => {
    const material = new THREE.ShaderMaterial({
      uniforms: { tint: { value: new THREE.Color() } },
      vertexShader: 'void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
      fragmentShader: 'uniform vec3 tint; void main() { gl_FragColor = vec4(tint, 1.0); }',
    });
    const group = new THREE.Group();
    for (let i = 0; i < 3; i++) {
      const mesh = new THREE.Mesh(new THREE.BoxGeometry(0.35, 0.8, 0.3), material);
      mesh.position.x = (i - 1) * 0.45;
      mesh.onBeforeRender = () => {
        (material.uniforms.tint.value as THREE.Color).setHSL(i / 3, 1, 0.5);
        material.uniformsNeedUpdate = true;
      };
      group.add(mesh);
    }
    return group;
  },
  'two objects in one place': () => {
    const group = new THREE.Group();
    for (const color of [0x442266, 0xcccc44])
      group.add(new THREE.Mesh(knot(), new Standard({ color, roughness: 0.5 })));
    return group;
  },
  'material changed before it is drawn': () => {
    const mesh = new THREE.Mesh(knot(), new Standard({ roughness: 0.5 }));
    mesh.onBeforeRender = (_r, _s, _c, _g, material) => (material as THREE.MeshStandardMaterial).color.set(0x4488ff);
    return mesh;
  },
};
