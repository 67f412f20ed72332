import type { TechniqueName } from '@farol/renderer';
import type * as Three from 'three';
import { checkAgreement } from '../support/agreement';
import type { Difference } from '../support/images';
import { expect, test } from '../support/benchTest';

/** Positions are not rebuilt from a depth that is too coarse, and far surfaces are not taken for background. */
test('cameras that see very near and very far, or through an oblique plane', async ({ benchPage: page }) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, isFlat, techniquesInTurn, three } = window.testPage;
    const width = 128;
    const height = 72;
    const bench = new Bench(width, height);
    bench.farol.inferredScale = 1;
    const names = techniquesInTurn(4);
    const found: (Difference & { name: string; technique: TechniqueName; flat: boolean })[] = [];
    const compare = (name: string, scene: Three.Scene, camera: Three.Camera) => {
      const stock = bench.stock(scene, camera);
      const flat = isFlat(stock);
      for (const technique of names)
        found.push({ name, technique, flat, ...compareImages(stock, bench.byTechnique(technique, scene, camera)) });
    };
    const { MeshStandardMaterial: Standard } = three;
    /** Balls side by side, none before another, lights near them; all of it `scale` times as large. */
    const balls = (scale: number, wall = false) => {
      const scene = new three.Scene();
      scene.background = new three.Color(0x334455);
      const materials = [
        new Standard({ color: 0xffccaa, roughness: 0.3 }),
        new three.MeshPhongMaterial({ color: 0x88aaff, shininess: 60 }),
        new three.MeshLambertMaterial({ color: 0x99ee99 }),
        new Standard({ color: 0xcccccc, roughness: 0.4, metalness: 0.8 }),
      ];
      for (let i = 0; i < 4; i++) {
        const ball = new three.Mesh(new three.SphereGeometry(scale * 0.8, 32, 24), materials[i]);
        ball.position.set(scale * (i * 2 - 3), scale * (i % 2 ? 0.6 : -0.6), scale * -i * 0.5);
        const lamp = new three.PointLight(0xffffff, 4 * scale * scale, 3 * scale);
        lamp.color.setHSL(i / 4, 0.6, 0.6);
        lamp.position.copy(ball.position).add({ x: scale * 0.6, y: scale * 0.5, z: scale * 1.1 } as Three.Vector3);
        scene.add(ball, lamp);
      }
      const spot = new three.SpotLight(0xffffff, 60 * scale * scale, 12 * scale, 0.9, 0.4);
      spot.position.set(0, 4 * scale, 5 * scale);
      scene.add(spot, spot.target, new three.DirectionalLight(0xffeedd, 0.6), new three.AmbientLight(0xffffff, 0.1));
      if (wall) {
        const plane = new three.Mesh(new three.PlaneGeometry(12 * scale, 7 * scale), materials[0]);
        plane.position.z = -4 * scale;
        // so near that a millimetre shows
        const close = new three.PointLight(0xffffff, 0.05, 2);
        close.position.set(-2, 1.2, -3.97);
        scene.add(plane, close);
      }
      return scene;
    };
    const camera = (near: number, far: number, z: number) => {
      const one = new three.PerspectiveCamera(45, width / height, near, far);
      one.position.z = z;
      return one;
    };
    compare('near 0.001, far 1e5', balls(1, true), camera(0.001, 1e5, 7));
    const afar = camera(0.001, 1e5, 300);
    afar.fov = 1.5;
    afar.updateProjectionMatrix();
    compare('near 0.001, far 1e5, from afar', balls(1), afar);
    compare('near 1e-6, far 50', balls(1), camera(1e-6, 50, 7));
    compare('planets', balls(1e6), camera(0.1, 1e9, 7e6));
    compare('planets at near 1e-3', balls(1e4), camera(1e-3, 1e6, 7e4));
    const endless = camera(0.1, 100, 7);
    endless.projectionMatrix.elements[10] = -1;
    endless.projectionMatrix.elements[14] = -0.2;
    endless.projectionMatrixInverse.copy(endless.projectionMatrix).invert();
    compare('no far plane', balls(1, true), endless);
    const dome = balls(1);
    const sky = new three.Mesh(
      new three.PlaneGeometry(1400, 700),
      new Standard({ color: 0x446688, emissive: 0x223344 }),
    );
    sky.position.z = -992.999;
    const lamp = new three.PointLight(0xffffff, 1e5, 400);
    lamp.position.set(150, 100, -900);
    dome.add(sky, lamp);
    compare('a wall as far as the far plane', dome, camera(0.1, 1000, 7));
    const box = new three.OrthographicCamera(-4, 4, 2.25, -2.25, 0, 20);
    const end = balls(1);
    const last = new three.Mesh(new three.PlaneGeometry(6, 4), new Standard({ color: 0xaa8866 }));
    box.position.z = 10;
    // depth rounds to 1; at the very plane, rounding would say what of it is clipped
    last.position.z = -9.999998;
    end.add(last);
    compare('a plane at the far plane, orthographic', end, box);
    // as a mirror's camera has it: what lies before the plane z = 0.9 of the world, which leans, is cut off
    const mirror = camera(0.1, 100, 7);
    mirror.updateMatrixWorld();
    const plane = new three.Plane(new three.Vector3(0.3, 0.2, -1).normalize(), 0.5).applyMatrix4(
      mirror.matrixWorldInverse,
    );
    const clip = new three.Vector4(plane.normal.x, plane.normal.y, plane.normal.z, plane.constant);
    const e = mirror.projectionMatrix.elements;
    const q = new three.Vector4(
      (Math.sign(clip.x) + e[8]) / e[0],
      (Math.sign(clip.y) + e[9]) / e[5],
      -1,
      (1 + e[10]) / e[14],
    );
    clip.multiplyScalar(2 / clip.dot(q));
    e[2] = clip.x;
    e[6] = clip.y;
    e[10] = clip.z + 1;
    e[14] = clip.w;
    mirror.projectionMatrixInverse.copy(mirror.projectionMatrix).invert();
    compare('an oblique near plane', balls(1, true), mirror);
    // and back, with the buffers that these have left
    compare('near 0.1, far 100', balls(1, true), camera(0.1, 100, 7));
    return found;
  });
  for (const { name, technique, flat, ...difference } of results) {
    expect(flat, name).toBe(false);
    const buffers = /deferred|light-prepass|auto/.test(technique);
    checkAgreement(technique, difference, name, buffers ? { psnr: 55, share: 0.001 } : {});
  }
});

/** As composers' own buffers, and canvases made with `depth: false`: the background lies behind, though no depth says so. */
test('targets and canvases without a depth buffer', async ({ benchPage: page }) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, isFlat, techniquesInTurn, three } = window.testPage;
    const [width, height] = [96, 64];
    const scene = new three.Scene();
    scene.background = new three.Color(0x334455);
    const lamp = new three.PointLight(0xffffff, 12, 6);
    lamp.position.set(1, 1.5, 2.5);
    scene.add(lamp, new three.AmbientLight(0xffffff, 0.3));
    // side by side: no picture depends on the order
    for (const x of [-1.4, 0, 1.4]) {
      const ball = new three.Mesh(new three.SphereGeometry(0.6, 24, 16), new three.MeshStandardMaterial());
      ball.position.x = x;
      scene.add(ball);
    }
    const camera = new three.PerspectiveCamera(50, width / height, 0.1, 20);
    camera.position.z = 5;
    const found: (Difference & { name: string; technique: TechniqueName; flat: boolean })[] = [];
    const names = techniquesInTurn(0);
    const target = new Bench(width, height, { target: { depthBuffer: false } });
    target.farol.inferredScale = 1;
    const inTarget = target.stock(scene, camera);
    for (const technique of names) {
      const difference = compareImages(inTarget, target.byTechnique(technique, scene, camera));
      found.push({ name: 'target', technique, flat: isFlat(inTarget), ...difference });
    }
    const { webgl, farol: onCanvas } = new Bench(width, height, { renderer: { depth: false } });
    onCanvas.inferredScale = 1;
    const read = (draw: () => void) => {
      draw();
      const bytes = new Uint8Array(width * height * 4);
      webgl.getContext().readPixels(0, 0, width, height, 6408, 5121, bytes);
      return { width, height, data: Float32Array.from(bytes, (byte) => (byte / 255) ** 2.2) };
    };
    const stock = read(() => webgl.render(scene, camera));
    for (const technique of names) {
      onCanvas.technique = technique;
      const picture = read(() => onCanvas.render(scene, camera));
      found.push({ name: 'canvas', technique, flat: isFlat(stock), ...compareImages(stock, picture) });
    }
    return found;
  });
  for (const { name, technique, flat, ...difference } of results) {
    expect.soft(flat, `${name}: shows something`).toBe(false);
    // a byte of the canvas is a step of up to 0.01 in linear light
    checkAgreement(technique, difference, name, { psnr: 40, ...(name === 'canvas' && { largest: 0.01 }) });
  }
});
