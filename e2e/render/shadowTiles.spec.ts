import type * as THREE from 'three';
import { expectAsMeasured } from '../support/agreement';
import { expect, test } from '../support/benchTest';

// Maps at rest have bounds, by which tiles of the picture go without look-ups: the picture must not show it.

interface Way {
  readonly renderer?: { readonly reversedDepthBuffer?: boolean; readonly logarithmicDepthBuffer?: boolean };
  /** An orthographic camera, which draws to a part of the target. */
  readonly isPart?: boolean;
  /** Beside stock three (dB). */
  readonly measured: number;
}

const ways: Record<string, Way> = {
  'at rest': { measured: 54.7 },
  'at rest, with reversed depth': { renderer: { reversedDepthBuffer: true }, measured: 54.7 },
  'at rest, by an orthographic camera in a part of the target': { isPart: true, measured: 65.6 },
  'at rest, with logarithmic depth, where tiles are not looked at': {
    renderer: { logarithmicDepthBuffer: true },
    measured: 54.4,
  },
};

for (const [name, way] of Object.entries(ways)) {
  const tag = name === 'at rest' ? '' : ' @verify';
  test(`a hall of shadows ${name}: as while it was new, and as stock three${tag}`, async ({ benchPage: page }) => {
    const result = await page.evaluate(({ renderer, isPart }) => {
      const { Bench, compareImages, three } = window.testPage;
      const bench = new Bench(192, 128, { renderer });
      bench.webgl.shadowMap.enabled = true;
      const scene = new three.Scene();
      const camera = isPart
        ? new three.OrthographicCamera(-6, 6, 4, -4, 0.1, 60)
        : new three.PerspectiveCamera(60, 1.5, 0.1, 60);
      if (isPart) bench.target.viewport.set(37, 21, 141, 94);
      camera.position.set(-9, 3, 1);
      camera.lookAt(4, 1.5, 0);
      const white = new three.MeshStandardMaterial();
      const add = (geometry: THREE.BufferGeometry, x: number, y: number, z: number) => {
        const mesh = new three.Mesh(geometry, white);
        mesh.position.set(x, y, z);
        mesh.castShadow = mesh.receiveShadow = true;
        scene.add(mesh);
        return mesh;
      };
      add(new three.BoxGeometry(24, 0.2, 10), 0, -0.1, 0);
      add(new three.BoxGeometry(24, 6, 0.2), 0, 3, -5);
      for (let i = 0; i < 6; i++) add(new three.CylinderGeometry(0.4, 0.4, 5), i * 3 - 8, 2.5, i % 2 ? 2 : -2);
      add(new three.SphereGeometry(0.8), -4, 0.8, 0);
      add(new three.BoxGeometry(9, 0.3, 4), 1, 1.7, 0);
      const lights: (THREE.PointLight | THREE.SpotLight)[] = [];
      for (let i = 0; i < 8; i++) {
        const x = i * 2.2 - 8;
        const point = i % 3 < 2;
        const light = point ? new three.PointLight(0xffd0a0, 20, 6) : new three.SpotLight(0xa0d0ff, 60, 9, 0.6, 0.3);
        light.position.set(x, 2.6 + (i % 4) * 0.5, i % 2 ? -1 : 1.2);
        if (light instanceof three.SpotLight) {
          light.target.position.set(x + 1, 0, 0);
          scene.add(light.target);
        }
        light.castShadow = true;
        light.shadow.mapSize.set(128, 128);
        light.shadow.camera.near = 0.1;
        light.shadow.bias = -0.004;
        light.shadow.radius = 1 + (i % 3);
        scene.add(light);
        lights.push(light);
      }
      const draw = () => bench.byTechnique('clustered-deferred', scene, camera);
      const { farol } = bench;
      const Farol = farol.constructor as new (webgl: THREE.WebGLRenderer) => typeof farol;
      // the first frame of a renderer knows no bounds
      const drawAnew = () => {
        const other = new Farol(bench.webgl);
        Object.assign(bench, { farol: other });
        const image = draw();
        const { bounded } = other.info.shadows;
        other.dispose();
        Object.assign(bench, { farol });
        return { image, bounded };
      };
      draw();
      const differences: number[] = [];
      const compare = (image: ReturnType<typeof draw>, other: ReturnType<typeof draw>) =>
        image.data.reduce((worst, value, i) => Math.max(worst, Math.abs(value - other.data[i])), 0);
      // new, then at rest; then each of these
      const bounded: number[] = [];
      const steps = [
        () => {},
        () => camera.position.set(-9.5, 2.2, 3),
        () => scene.children[4].position.setX(-5.5),
        () => lights[3].position.setY(3.4),
        () => lights.forEach(({ shadow }) => (shadow.normalBias = 0.6)),
        () => lights.forEach(({ shadow }) => (shadow.intensity = 0.5)),
        () => {
          lights.forEach(({ shadow }) => (shadow.intensity = 1));
          scene.children.forEach((mesh, i) => (mesh.receiveShadow = i % 2 === 1));
        },
      ];
      let psnr = Infinity;
      for (const step of steps) {
        step();
        const anew = drawAnew();
        for (let i = 0; i < 4; i++) differences.push(compare(anew.image, draw()));
        bounded.push(anew.bounded, farol.info.shadows.bounded);
        psnr = Math.min(psnr, compareImages(bench.stock(scene, camera), draw()).psnr);
      }
      return { differences, bounded, psnr };
    }, way);
    expect(Math.max(...result.differences)).toBe(0);
    expect(result.bounded).toEqual([0, 8, 0, 8, 0, 8, 0, 8, 0, 8, 0, 8, 0, 8]);
    expectAsMeasured(result.psnr, way.measured, 'as stock three');
  });
}
