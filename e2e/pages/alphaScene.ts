import * as THREE from 'three';
import { Bench, type PageImage } from './Bench';

/** Things of each kind of blending without a background, to see the alpha: opaque, transparent, additive, glass. */
export function alphaScene(width: number, height: number) {
  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(50, width / height, 0.1, 30);
  camera.position.z = 6;
  const ball = new THREE.SphereGeometry(0.6, 24, 16);
  const { AdditiveBlending, NoBlending, MultiplyBlending } = THREE;
  const things: THREE.Object3D[] = [
    { color: 0xffaa88 },
    { color: 0xffff88, transparent: true, opacity: 0.5 },
    { color: 0x88ffff, transparent: true, opacity: 0.4, blending: AdditiveBlending },
    { color: 0x88ff88, transparent: true, opacity: 0.6, blending: MultiplyBlending, premultipliedAlpha: true },
    { color: 0xff88ff, transparent: true, opacity: 0.6, premultipliedAlpha: true },
    { color: 0xff88ff, opacity: 0.4, blending: NoBlending },
    { color: 0xff8888, opacity: 0.4, blending: AdditiveBlending },
    { color: 0x8888ff, opacity: 0.4, alphaHash: true },
    { color: 0x8888ff, transmission: 1, roughness: 0.1 },
    { color: 0x8888ff, transmission: 1, transparent: true, opacity: 0.5, side: THREE.DoubleSide },
  ].map((parameters) => new THREE.Mesh(ball, new THREE.MeshPhysicalMaterial(parameters)));
  things.push(
    new THREE.Mesh(ball, new THREE.MeshBasicMaterial({ color: 0x88ff88, opacity: 0.4 })),
    new THREE.Mesh(ball, new THREE.MeshBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.7 })),
    new THREE.Mesh(
      ball,
      new THREE.ShaderMaterial({
        vertexShader: 'void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
        fragmentShader: 'void main() { gl_FragColor = vec4(0.2, 0.3, 0.1, 0.6); }',
      }),
    ),
    new THREE.Sprite(new THREE.SpriteMaterial({ color: 0xffffff, opacity: 0.3 })),
    new THREE.Points(ball, new THREE.PointsMaterial({ size: 0.1, opacity: 0.5, transparent: true })),
    new THREE.Line(ball, new THREE.LineBasicMaterial({ opacity: 0.5, transparent: true })),
    new THREE.Mesh(ball, new THREE.ShadowMaterial({ opacity: 0.5 })),
    new THREE.Mesh(ball, new THREE.MeshPhysicalMaterial({ clearcoat: 1, opacity: 0.5, blending: NoBlending })),
  );
  things.forEach((thing, i) => {
    thing.position.set((i % 6) * 1.2 - 3, Math.floor(i / 6) * 1.6 - 1.6, 0);
    scene.add(thing);
  });
  const lamp = new THREE.PointLight(0xffffff, 40);
  lamp.position.set(2, 3, 4);
  scene.add(lamp, new THREE.AmbientLight(0xffffff, 0.3));
  return { scene, camera };
}

/** A bench whose canvas is seen through, and a way to read what is drawn to it: 0 to 1, encoded, multiplied by alpha. */
export function alphaBench(width: number, height: number) {
  const bench = new Bench(width, height, { renderer: { alpha: true } });
  const { webgl } = bench;
  const toCanvas = (render: () => void): PageImage => {
    render();
    const gl = webgl.getContext();
    const bytes = new Uint8Array(width * height * 4);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return { width, height, data: Float32Array.from(bytes, (byte) => byte / 255) };
  };
  return { bench, toCanvas };
}
