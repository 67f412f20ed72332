import { expect, test } from '../support/benchTest';

test('a dithered material is dithered once, in the colours of the canvas, by every technique', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(() => {
    const { Bench, farol: library, three } = window.testPage;
    const [width, height] = [96, 64];
    const scene = new three.Scene();
    const material = new three.MeshLambertMaterial();
    material.color.setScalar((120 / 255) ** 2); // whose square root a G-buffer keeps unrounded
    const floor = new three.Mesh(new three.PlaneGeometry(8, 8), material);
    const light = new three.PointLight(0xffffff, 0.6, 12);
    light.position.set(-2, 0.5, 1.5);
    scene.add(floor, light, new three.AmbientLight(0xffffff, 0.01));
    const camera = new three.PerspectiveCamera(50, width / height, 0.1, 20);
    camera.position.z = 4;
    const bench = new Bench(width, height);
    const gl = bench.webgl.getContext();
    const read = (draw: () => void) => {
      draw();
      const bytes = new Uint8Array(width * height * 4);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      return bytes;
    };
    /** Change of each channel by dithering (steps of 1/255). */
    const changes = (draw: () => void) => {
      const [plain, dithered] = [false, true].map((dithering) => {
        material.dithering = dithering;
        material.needsUpdate = true;
        return read(draw);
      });
      return plain.map((value, i) => 128 + dithered[i] - value);
    };
    const wanted = changes(() => bench.webgl.render(scene, camera));
    const names = Object.keys(library.techniques).filter((name) => name !== 'auto');
    const off = names.map((name): [string, number, number] => {
      bench.farol.technique = name as never;
      const found = changes(() => bench.farol.render(scene, camera));
      const apart = found.filter((value, i) => value !== wanted[i]).length / found.length;
      return [name, apart, Math.max(...found.map((value, i) => Math.abs(value - wanted[i])))];
    });
    /** Change by dithering in a target of floats (linear). */
    const adds = (draw: () => { data: Float32Array }) => {
      const [plain, dithered] = [false, true].map((dithering) => {
        material.dithering = dithering;
        material.needsUpdate = true;
        return draw().data;
      });
      return plain.map((value, i) => dithered[i] - value);
    };
    const added = adds(() => bench.stock(scene, camera));
    const linear = names.map((name): [string, number] => {
      const found = adds(() => bench.byTechnique(name as never, scene, camera));
      return [name, Math.max(...found.map((value, i) => Math.abs(value - added[i])))];
    });
    return { off, linear, dithered: wanted.filter((value) => value !== 128).length / wanted.length };
  });
  expect(found.dithered, 'share of channels that stock three changes').toBeGreaterThan(0.1);
  for (const [name, share, most] of found.off) {
    expect.soft(share, `${name}: share of channels that it changes otherwise`).toBeLessThan(0.02);
    expect.soft(most, `${name}: most`).toBeLessThanOrEqual(1);
  }
  // a target of half floats rounds away some of the dithering
  for (const [name, most] of found.linear) expect.soft(most * 255, `${name}, float target`).toBeLessThan(0.05);
});

test('a dithered material is dithered by its place in the target, by every technique, when cameras draw to parts of it', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(() => {
    const { Bench, farol: library, three } = window.testPage;
    const scene = new three.Scene();
    const material = new three.MeshLambertMaterial({ color: 0x888888 });
    const light = new three.PointLight(0xffffff, 0.6, 12);
    light.position.set(-2, 0.5, 1.5);
    scene.add(new three.Mesh(new three.PlaneGeometry(8, 8), material), light);
    const camera = new three.PerspectiveCamera(50, 40 / 50, 0.1, 20);
    camera.position.z = 4;
    const bench = new Bench(96, 64);
    const { farol, target, webgl } = bench;
    /** Change by dithering (linear) of a target in whose two parts two cameras draw. */
    const adds = (render: (camera: InstanceType<typeof three.Camera>) => void) => {
      const [plain, dithered] = [false, true].map((dithering) => {
        material.dithering = dithering;
        material.needsUpdate = true;
        return bench.draw(() => {
          target.scissorTest = true;
          for (const x of [3, 51]) {
            target.viewport.set(x, 7, 40, 50);
            target.scissor.copy(target.viewport);
            webgl.setRenderTarget(target);
            camera.position.x = x / 50;
            render(camera);
          }
        }).data;
      });
      return plain.map((value, i) => dithered[i] - value);
    };
    const added = adds((seen) => webgl.render(scene, seen));
    const names = Object.keys(library.techniques).filter((name) => name !== 'auto');
    const off = names.map((name): [string, number] => {
      farol.technique = name as never;
      const found = adds((seen) => farol.render(scene, seen));
      return [name, Math.max(...found.map((value, i) => Math.abs(value - added[i])))];
    });
    return { off, dithered: added.filter((value) => value !== 0).length / added.length };
  });
  // three of four channels, in two parts of the target
  expect(found.dithered, 'share of values that stock three changes').toBeGreaterThan(0.4);
  for (const [name, most] of found.off) expect.soft(most * 255, name).toBeLessThan(0.05);
});

for (const isChanged of [false, true]) {
  test(`the disk of a soft shadow is turned by the place in the target, by every technique, when a camera draws to a part of it${isChanged ? ', where the host has changed the look-up of shadows @verify' : ''}`, async ({
    benchPage: page,
  }) => {
    const pairs = await page.evaluate((isChanged) => {
      const { Bench, compareImages, farol: library, three } = window.testPage;
      const scene = new three.Scene();
      const material = new three.MeshLambertMaterial({ color: 0x888888 });
      const floor = new three.Mesh(new three.PlaneGeometry(12, 12), material);
      floor.receiveShadow = true;
      const caster = new three.Mesh(new three.TorusKnotGeometry(0.6, 0.2, 64, 12), material);
      caster.position.z = 1;
      caster.castShadow = true;
      const light = new three.SpotLight(0xffffff, 40, 12, 0.6);
      light.position.set(-1.5, 1, 4);
      light.castShadow = true;
      light.shadow.mapSize.set(64, 64);
      light.shadow.radius = 4;
      scene.add(floor, caster, light, light.target);
      const camera = new three.PerspectiveCamera(50, 1, 0.1, 20);
      camera.position.z = 5;
      const bench = new Bench(128, 96);
      const { farol, target, webgl } = bench;
      webgl.shadowMap.enabled = true;
      const inPart = (x: number, y: number, render: () => void) =>
        bench.draw(() => {
          target.scissorTest = true;
          target.viewport.set(x, y, 80, 80);
          target.scissor.copy(target.viewport);
          webgl.setRenderTarget(target);
          render();
        });
      const { shadowmap_pars_fragment: text } = three.ShaderChunk;
      if (isChanged) three.ShaderChunk.shadowmap_pars_fragment += '\n// changed';
      const names = Object.keys(library.techniques).filter((name) => name !== 'auto' && name !== 'inferred');
      const found = names.map((name) => {
        farol.technique = name as never;
        const [corner, part] = [
          [0, 0],
          [33, 7],
        ].map(([x, y]) => {
          const stock = inPart(x, y, () => webgl.render(scene, camera));
          return compareImages(
            stock,
            inPart(x, y, () => farol.render(scene, camera)),
          ).psnr;
        });
        return { name, corner, part };
      });
      three.ShaderChunk.shadowmap_pars_fragment = text;
      return found;
    }, isChanged);
    // an H100 rounds to 113.5 dB in a part; a disk turned by another pixel gives 35
    const most = process.env.FAROL_GPU ? 113 : 120;
    for (const { name, corner, part } of pairs)
      expect.soft(part, `${name}, dB; ${corner} in the corner`).toBeGreaterThan(Math.min(corner, most) - 3);
  });
}
