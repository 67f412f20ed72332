import { expect, test } from '../support/benchTest';

const TECHNIQUES = ['deferred', 'light-prepass', 'forward-plus'] as const;

/** The corner of a floor and a wall, with a decal on the floor. */
test('ambient occlusion and decals are the same by logarithmic and reversed depth, and right by an orthographic camera', async ({
  benchPage: page,
}) => {
  const { apart, corner, laid, seen } = await page.evaluate(
    ([width, height, techniques]) => {
      const { Bench, compareImages, effects, techniquesInTurn, three } = window.testPage;
      const scene = new three.Scene();
      scene.background = new three.Color(0.1, 0.2, 0.4);
      const material = new three.MeshStandardMaterial({ roughness: 1 });
      const floor = new three.Mesh(new three.PlaneGeometry(40, 40), material);
      floor.rotation.x = -Math.PI / 2;
      const wall = new three.Mesh(new three.PlaneGeometry(40, 3), material);
      wall.position.y = 1.5;
      const lamp = new three.PointLight(0xffeedd, 12, 9);
      lamp.position.set(0.5, 2, 1.5);
      const surface = new three.MeshStandardMaterial({ color: 0xdd4422, roughness: 0.6 });
      const patch = new three.Mesh(new three.PlaneGeometry(1.6, 1.2), surface.clone());
      // over the floor whatever the kind of depth: an offset of polygons does nothing to depths that a shader writes
      patch.material.depthTest = false;
      patch.renderOrder = 1;
      const decal = new effects.Decal(surface);
      decal.scale.set(1.6, 1.2, 0.3);
      for (const object of [patch, decal]) {
        object.rotation.set(-Math.PI / 2, 0, 0.4);
        object.position.set(0.1, 0, 2.2);
      }
      scene.add(floor, wall, lamp, new three.AmbientLight(0xffffff, 1), decal, patch);
      const perspective = new three.PerspectiveCamera(60, width / height, 0.1, 100);
      const orthographic = new three.OrthographicCamera((-4 * width) / height, (4 * width) / height, 4, -4, 0.1, 60);
      const cameras = { perspective, orthographic };
      for (const camera of Object.values(cameras)) {
        camera.position.set(0, 4, 6);
        camera.lookAt(0, 0.5, 0);
        camera.updateMatrixWorld();
      }
      const kinds = {
        plain: {},
        logarithmic: { logarithmicDepthBuffer: true },
        reversed: { reversedDepthBuffer: true },
      };
      const apart: Record<string, number> = {};
      const laid: Record<string, number> = {};
      const seen: Record<string, number> = {};
      const corner: Record<string, number> = {};
      const images: Record<string, ReturnType<typeof plainOf>> = {};
      const plainOf = (
        bench: InstanceType<typeof Bench>,
        name: (typeof techniques)[number],
        camera: typeof perspective,
      ) => bench.byTechnique(name, scene, camera);
      for (const [kind, renderer] of Object.entries(kinds)) {
        const bench = new Bench(width, height, { renderer });
        for (const [name, any] of Object.entries(cameras)) {
          const camera = any as typeof perspective;
          const decals = new effects.Decals();
          const ao = new effects.AmbientOcclusion();
          ao.radius = 1.5;
          decal.visible = false;
          patch.visible = true;
          const wanted = bench.stock(scene, camera);
          patch.visible = false;
          for (const technique of techniquesInTurn(0, techniques)) {
            const key = `${name}, ${technique}`;
            bench.farol.effects = [];
            decal.visible = false;
            const open = plainOf(bench, technique, camera);
            bench.farol.effects = [ao];
            const closed = plainOf(bench, technique, camera);
            const foot = new three.Vector3(-2.5, 0, 0).project(camera);
            const at = (y: number) =>
              (Math.round((foot.y * 0.5 + 0.5) * height + y) * width + Math.round((foot.x * 0.5 + 0.5) * width)) * 4;
            corner[`${key}, ${kind}`] = closed.data[at(-2)] / open.data[at(-2)];
            if (technique === 'deferred') {
              decal.visible = true;
              bench.farol.effects = [decals];
              const put = plainOf(bench, technique, camera);
              laid[`${key}, ${kind}`] = compareImages(wanted, put).psnr;
              seen[`${key}, ${kind}`] = compareImages(open, put).psnr;
              bench.farol.effects = [decals, ao];
            }
            const image = plainOf(bench, technique, camera);
            images[`${key}, ${kind}`] = image;
            apart[`${key}, ${kind}`] = compareImages(images[`${key}, plain`], image).psnr;
          }
        }
        bench.farol.dispose();
        bench.webgl.dispose();
      }
      return { apart, corner, laid, seen };
    },
    [120, 90, TECHNIQUES] as const,
  );
  test.info().annotations.push({ type: 'depth', description: JSON.stringify({ apart, corner, laid, seen }) });
  for (const [name, psnr] of Object.entries(apart)) expect(psnr, `${name} as with plain depth`).toBeGreaterThan(45);
  for (const [name, share] of Object.entries(corner)) {
    // half of what is ambient light
    expect(share, `light left in the corner: ${name}`).toBeGreaterThan(0.45);
    expect(share, `light left in the corner: ${name}`).toBeLessThan(0.8);
  }
  for (const [name, psnr] of Object.entries(laid)) expect(psnr, `decal as a mesh: ${name}`).toBeGreaterThan(40);
  for (const [name, psnr] of Object.entries(seen)) expect(psnr, `decal is seen: ${name}`).toBeLessThan(30);
});
