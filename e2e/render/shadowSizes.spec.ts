import { expect, test } from '../support/benchTest';

/** Shadow maps that have fewer texels than lights ask for, since pictures show no more: against stock three, in linear float. */
const WIDTH = 480;
const HEIGHT = 720;

test('lights at 5, 15, 30 and 60 m: fewer texels, and the picture of stock three', async ({ benchPage: page }) => {
  const seen = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, three } = window.testPage;
      const bench = new Bench(width, height);
      bench.webgl.shadowMap.enabled = true;
      return (['point', 'spot'] as const).map((kind) => {
        const scene = new three.Scene();
        const camera = new three.PerspectiveCamera(50, width / height, 0.1, 200);
        camera.position.set(0, 7, 0);
        camera.lookAt(0, 0, -25);
        const material = new three.MeshStandardMaterial({ color: 0xcccccc });
        const floor = new three.Mesh(new three.PlaneGeometry(60, 160), material);
        floor.rotation.x = -Math.PI / 2;
        floor.position.z = -60;
        scene.add(floor);
        const shapes = [
          new three.BoxGeometry(0.5, 1.4, 0.5),
          new three.SphereGeometry(0.4, 24, 16),
          new three.TorusKnotGeometry(0.4, 0.12, 64, 8),
        ];
        let asked = 0;
        for (const distance of [5, 15, 30, 60]) {
          const light =
            kind === 'spot' ? new three.SpotLight(0xffffff, 120, 12, 0.6, 0.3) : new three.PointLight(0xffffff, 60, 8);
          const y = kind === 'spot' ? 6 : 3;
          const [x, z] = [distance === 5 ? 0 : 3, -Math.sqrt(distance ** 2 - (7 - y) ** 2)];
          light.position.set(x, y, z);
          if (light instanceof three.SpotLight) {
            light.target.position.set(x + 1, 0, z - 1);
            scene.add(light.target);
          }
          light.castShadow = true;
          light.shadow.mapSize.set(512, 512);
          light.shadow.bias = -0.002;
          light.shadow.camera.near = 0.1;
          scene.add(light);
          asked += (kind === 'spot' ? 1 : 6) * 512 ** 2;
          for (let i = 0; i < 10; i++) {
            const [turn, away] = [i * 0.628 + distance, 1 + 0.45 * (i % 5)];
            const thing = new three.Mesh(shapes[i % 3], material);
            thing.position.set(x + away * Math.cos(turn), 0.7 + 0.15 * (i % 4), z + away * Math.sin(turn));
            thing.rotation.y = i;
            scene.add(thing);
          }
        }
        scene.traverse((object) => {
          if (object instanceof three.Mesh) object.castShadow = object.receiveShadow = true;
        });
        const image = bench.byTechnique('forward-single-pass', scene, camera);
        const { texels } = bench.farol.info.shadows;
        const stock = bench.stock(scene, camera);
        scene.traverse((object) => (object.castShadow = false));
        const matters = compareImages(stock, bench.stock(scene, camera)).psnr;
        return { kind, texels, asked, matters, psnr: compareImages(stock, image).psnr };
      });
    },
    [WIDTH, HEIGHT] as const,
  );
  for (const { kind, texels, asked, matters, psnr } of seen) {
    test
      .info()
      .annotations.push({ type: 'agreement', description: `${kind}: ${psnr.toFixed(1)} dB, ${texels} texels` });
    expect(matters, `${kind}: the shadows are to be seen`).toBeLessThan(32);
    expect(texels, kind).toBeLessThan(0.9 * asked);
    expect(psnr, kind).toBeGreaterThanOrEqual(50);
  }
});

test('sides that are seen cast no shadows on themselves, at grazing light, with a bias that is just enough for the size asked for', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, farol, three } = window.testPage;
      const bench = new Bench(width, height);
      bench.webgl.shadowMap.enabled = true;
      const scene = new three.Scene();
      const camera = new three.PerspectiveCamera(20, width / height, 1, 300);
      camera.position.set(0, 12, 0);
      camera.lookAt(0, 0, -180);
      const material = new three.MeshStandardMaterial({ color: 0xcccccc, shadowSide: three.FrontSide });
      const floor = new three.Mesh(new three.PlaneGeometry(60, 300), material);
      floor.rotation.x = -Math.PI / 2;
      floor.position.z = -180;
      const wall = new three.Mesh(new three.PlaneGeometry(60, 6), material);
      wall.position.set(0, 2, -183);
      wall.rotation.y = 0.1;
      const ball = new three.Mesh(new three.SphereGeometry(1.5, 48, 32), material);
      ball.position.set(2.5, 0, -180);
      const light = new three.SpotLight(0xffffff, 120, 8, 0.6, 0.3);
      light.position.set(-2, 1.2, -179);
      light.target.position.set(1, 0, -179);
      light.castShadow = true;
      light.shadow.mapSize.set(512, 512);
      light.shadow.bias = -0.0003;
      light.shadow.camera.near = 0.1;
      for (const mesh of [floor, wall, ball]) mesh.castShadow = mesh.receiveShadow = true;
      scene.add(floor, wall, ball, light, light.target);
      const draw = () => {
        const own = new farol.FarolRenderer(bench.webgl, { technique: 'forward-single-pass' });
        bench.webgl.setRenderTarget(bench.target);
        own.render(scene, camera);
        const data = new Float32Array(width * height * 4);
        bench.webgl.readRenderTargetPixels(bench.target, 0, 0, width, height, data);
        bench.webgl.setRenderTarget(null);
        const { texels } = own.info.shadows;
        own.dispose();
        return { width, height, data, texels };
      };
      const reduced = draw();
      // a map that the host has drawn once keeps the size asked for
      light.shadow.autoUpdate = false;
      light.shadow.needsUpdate = true;
      const whole = draw();
      // sides that are not seen are far from those that are
      material.shadowSide = three.BackSide;
      material.needsUpdate = true;
      light.shadow.needsUpdate = true;
      const clean = draw();
      return {
        texels: reduced.texels,
        asked: whole.texels,
        enough: compareImages(clean, whole).psnr,
        psnr: compareImages(whole, reduced).psnr,
      };
    },
    [WIDTH, HEIGHT] as const,
  );
  test.info().annotations.push({ type: 'acne', description: JSON.stringify(seen) });
  expect(seen.texels).toBeLessThan(0.3 * seen.asked);
  expect(seen.enough, 'at the size asked for').toBeGreaterThanOrEqual(50);
  expect(seen.psnr, 'reduced').toBeGreaterThanOrEqual(50);
});

test('maps stay as they are while cameras take turns, and a camera that comes near has a map drawn anew, once', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(
    ([width, height]) => {
      const { Bench, three } = window.testPage;
      const bench = new Bench(width / 8, height / 8);
      bench.webgl.shadowMap.enabled = true;
      const scene = new three.Scene();
      const material = new three.MeshStandardMaterial();
      const wall = new three.Mesh(new three.PlaneGeometry(20, 20), material);
      const box = new three.Mesh(new three.BoxGeometry(), material);
      box.position.z = 1;
      const light = new three.PointLight(0xffffff, 20, 6);
      light.position.z = 3;
      light.castShadow = box.castShadow = wall.receiveShadow = true;
      light.shadow.mapSize.set(256, 256);
      scene.add(wall, box, light);
      const cameras = [8, 200].map((z) => {
        const camera = new three.PerspectiveCamera(50, width / height, 0.1, 400);
        camera.position.z = z;
        return camera;
      });
      const frames = (picks: readonly number[], moves: boolean) =>
        picks.map((i) => {
          if (moves) box.position.x += 0.01;
          bench.byTechnique('forward-single-pass', scene, cameras[i]);
          const { drawn, texels } = bench.farol.info.shadows;
          return drawn && texels;
        });
      return {
        far: frames([1, 1], false),
        near: frames([0, 0], false),
        turns: frames([1, 0, 1, 0, 1, 0], false),
        moving: frames(
          Array.from({ length: 40 }, (_, i) => i % 2),
          true,
        ).filter((texels) => texels === 0).length,
        farAgain: frames(Array(40).fill(1), false),
        moved: frames([1], true),
      };
    },
    [WIDTH, HEIGHT] as const,
  );
  const whole = 6 * 260 ** 2;
  expect(seen.far[0]).toBeLessThan(0.3 * whole);
  expect(seen.far[1]).toBe(0);
  expect(seen.near).toEqual([whole, 0]);
  expect(seen.turns).toEqual([0, 0, 0, 0, 0, 0]);
  expect(seen.moving, 'frames in which nothing was drawn though the box moved').toBe(0);
  expect(seen.farAgain).toEqual(Array(40).fill(0));
  expect(seen.moved[0]).toBeGreaterThan(0);
  expect(seen.moved[0]).toBeLessThan(0.3 * whole);
});
