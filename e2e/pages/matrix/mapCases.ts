import * as THREE from 'three';
import type { Cases } from './Case';
import { brightMap, colourMap, greyMap, holes, normalMap, objectNormalMap } from './textures';

const { MeshStandardMaterial: Standard } = THREE;
const sphere = new THREE.SphereGeometry(0.65, 32, 24);
sphere.setAttribute('uv1', sphere.attributes.uv);
const on = (material: THREE.Material) => new THREE.Mesh(sphere, material);

/** A sphere cut by planes through a place beside its centre. */
function clipped(normals: THREE.Vector3[], material: THREE.Material): THREE.Mesh {
  const mesh = on(material);
  const planes = normals.map((normal) => new THREE.Plane(normal.normalize()));
  material.clippingPlanes = planes;
  mesh.onBeforeRender = () => {
    const place = mesh.getWorldPosition(new THREE.Vector3()).addScalar(0.1);
    for (const plane of planes) plane.setFromNormalAndCoplanarPoint(plane.normal, place);
  };
  return mesh;
}

function coloured(): THREE.BufferGeometry {
  const geometry = new THREE.SphereGeometry(0.65, 16, 12);
  const { position } = geometry.attributes;
  const colours = new Float32Array(position.count * 4);
  for (let i = 0; i < position.count; i++)
    colours.set(
      [((i * 37) % 100) / 100, ((i * 53) % 100) / 100, ((i * 71) % 100) / 100, ((i * 29) % 100) / 100],
      i * 4,
    );
  geometry.setAttribute('color', new THREE.BufferAttribute(colours, 4));
  return geometry;
}

/** Every map of a lit material, and how its surface is drawn. None changes the order in which opaque things must be drawn. */
export const mapCases: Cases = {
  'normal map': () =>
    on(new Standard({ roughness: 0.5, normalMap: normalMap(), normalScale: new THREE.Vector2(0.8, -0.6) })),
  'normal map in object space': () =>
    on(new Standard({ roughness: 0.5, normalMap: objectNormalMap(), normalMapType: THREE.ObjectSpaceNormalMap })),
  'normal map with tangents': () => {
    const geometry = new THREE.SphereGeometry(0.65, 24, 16);
    geometry.computeTangents();
    return new THREE.Mesh(geometry, new THREE.MeshPhongMaterial({ normalMap: normalMap() }));
  },
  'bump map': () => on(new Standard({ roughness: 0.5, bumpMap: greyMap(), bumpScale: 2 })),
  'displacement map': () =>
    on(new Standard({ roughness: 0.5, displacementMap: greyMap(), displacementScale: 0.2, displacementBias: -0.1 })),
  'alpha map and test': () => on(new Standard({ roughness: 0.5, alphaMap: holes(), alphaTest: 0.5 })),
  'alpha test of a map, both sides': () =>
    on(new THREE.MeshPhongMaterial({ map: holes(), alphaTest: 0.45, side: THREE.DoubleSide })),
  'alpha hash': () => on(new THREE.MeshLambertMaterial({ opacity: 0.5, alphaHash: true })),
  'alpha hash, standard': () => on(new Standard({ opacity: 0.6, alphaHash: true, roughness: 0.6 })),
  'ambient occlusion': () => on(new Standard({ aoMap: greyMap(), aoMapIntensity: 0.9, roughness: 0.6 })),
  'light map': () => on(new Standard({ lightMap: colourMap(), lightMapIntensity: 0.6, roughness: 0.6 })),
  'light map, lambert': () => on(new THREE.MeshLambertMaterial({ lightMap: colourMap(), aoMap: greyMap() })),
  'specular map': () => on(new THREE.MeshPhongMaterial({ specularMap: greyMap(), specular: 0xffffff, shininess: 25 })),
  'emissive map': () =>
    on(new Standard({ emissiveMap: colourMap(), emissive: 0x884400, emissiveIntensity: 2, roughness: 0.5 })),
  'map of values above 1': () => on(new Standard({ map: brightMap(), roughness: 0.8 })),
  'map, shifted and turned': () => {
    const map = colourMap();
    map.repeat.set(2, 3);
    map.offset.set(0.2, 0.1);
    map.rotation = 0.5;
    return on(new Standard({ map, roughness: 0.6 }));
  },
  'vertex colours': () => new THREE.Mesh(coloured(), new Standard({ vertexColors: true, roughness: 0.5 })),
  'vertex colours with alpha': () =>
    new THREE.Mesh(coloured(), new THREE.MeshLambertMaterial({ vertexColors: true, transparent: true })),
  'flat shading': () => on(new Standard({ flatShading: true, roughness: 0.5 })),
  'flat shading, phong': () => on(new THREE.MeshPhongMaterial({ flatShading: true })),
  'back side': () => on(new Standard({ side: THREE.BackSide, roughness: 0.5 })),
  'both sides of a bowl': () => {
    const bowl = new THREE.Mesh(
      new THREE.SphereGeometry(0.65, 16, 12, 0, Math.PI),
      new Standard({ side: THREE.DoubleSide, roughness: 0.5 }),
    );
    bowl.rotation.y = 2;
    return bowl;
  },
  'negative scale': () => {
    const mesh = new THREE.Mesh(
      new THREE.ConeGeometry(0.6, 1.1, 7),
      new Standard({ roughness: 0.4, map: colourMap() }),
    );
    mesh.scale.set(-1, 1, 1);
    mesh.rotation.z = 0.5;
    return mesh;
  },
  wireframe: () => on(new Standard({ wireframe: true })),
  'clipped by a plane of its own': () =>
    clipped([new THREE.Vector3(0.3, -0.5, 0.2)], new Standard({ side: THREE.DoubleSide, roughness: 0.5 })),
  'clipped where planes intersect': () =>
    clipped(
      [new THREE.Vector3(1, 0, 0), new THREE.Vector3(0, 1, 0)],
      new THREE.MeshLambertMaterial({ clipIntersection: true, side: THREE.DoubleSide }),
    ),
  'polygon offset': () => {
    const group = new THREE.Group();
    const quad = new THREE.PlaneGeometry(1, 1);
    group.add(new THREE.Mesh(quad, new Standard({ color: 0x4466aa, roughness: 0.6 })));
    const upper = new Standard({
      color: 0xaa6644,
      roughness: 0.6,
      polygonOffset: true,
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -4,
    });
    group.add(new THREE.Mesh(new THREE.PlaneGeometry(0.5, 0.5), upper));
    return group;
  },
  'material that is not visible': () => on(new Standard({ visible: false })),
  'no fog, no tone mapping': () => on(new Standard({ fog: false, toneMapped: false, roughness: 0.5 })),
  transparent: () => on(new Standard({ color: 0x88ccff, transparent: true, opacity: 0.5, roughness: 0.4 })),
  'transparent, both sides': () =>
    on(new THREE.MeshPhongMaterial({ color: 0x88ccff, transparent: true, opacity: 0.5, side: THREE.DoubleSide })),
  'transparent, both sides in one pass': () =>
    on(new THREE.MeshPhongMaterial({ transparent: true, opacity: 0.5, side: THREE.DoubleSide, forceSinglePass: true })),
  'additive blending': () => on(new Standard({ color: 0x446688, transparent: true, blending: THREE.AdditiveBlending })),
  multiplied: () =>
    on(
      new THREE.MeshBasicMaterial({
        color: 0xaa8866,
        transparent: true,
        blending: THREE.MultiplyBlending,
        premultipliedAlpha: true,
      }),
    ),
  'subtractive, lit': () =>
    on(
      new THREE.MeshLambertMaterial({
        color: 0x333333,
        transparent: true,
        blending: THREE.SubtractiveBlending,
        premultipliedAlpha: true,
      }),
    ),
  'blended by maximum': () =>
    on(
      new Standard({
        color: 0x4466ff,
        transparent: true,
        blending: THREE.CustomBlending,
        blendEquation: THREE.MaxEquation,
      }),
    ),
  'premultiplied alpha': () => on(new Standard({ transparent: true, opacity: 0.6, premultipliedAlpha: true })),
  dithered: () => on(new Standard({ dithering: true, roughness: 0.7 })),
};
