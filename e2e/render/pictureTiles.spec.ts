import { expect, test } from '../support/benchTest';

test('tiles of a picture have the shadows of the whole, and meet without a seam @verify', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const [width, height, margin] = [256, 96, 8];
    const scene = new three.Scene();
    scene.background = new three.Color(0.3, 0.4, 0.6);
    const material = new three.MeshLambertMaterial();
    const ground = new three.Mesh(new three.PlaneGeometry(400, 400), material);
    ground.rotation.x = -Math.PI / 2;
    ground.receiveShadow = true;
    const post = new three.BoxGeometry(0.4, 3, 0.4);
    for (let i = 0; i < 60; i++) {
      const mesh = new three.Mesh(post, material);
      mesh.position.set(((i % 10) - 4.5) * 4, 1.5, -2 - 3 * Math.floor(i / 10) ** 2);
      mesh.castShadow = mesh.receiveShadow = true;
      scene.add(mesh);
    }
    const sun = new three.DirectionalLight(0xffffff, 3);
    sun.position.set(30, 40, 10);
    sun.castShadow = true;
    sun.shadow.mapSize.set(512, 512);
    Object.assign(sun.shadow.camera, { left: -100, right: 100, top: 100, bottom: -100, far: 200 });
    const lamp = new three.SpotLight(0xffaa66, 400, 40, 0.9);
    lamp.position.set(0, 8, -2);
    lamp.target.position.set(1, 0, -4);
    lamp.castShadow = true;
    scene.add(ground, sun, lamp, lamp.target, new three.AmbientLight(0xffffff, 0.2));
    const camera = new three.PerspectiveCamera(50, width / height, 0.1, 300);
    camera.position.set(0, 5, 14);
    camera.lookAt(0, 1, -6);
    const bench = new Bench(width, height);
    bench.webgl.shadowMap.enabled = true;
    bench.farol.shadowCascades = 3;
    return (['deferred', 'clustered-forward'] as const).map((technique) => {
      bench.setSize(width, height);
      camera.clearViewOffset();
      const whole = bench.byTechnique(technique, scene, camera);
      const tile = (from: number, to: number) => {
        bench.setSize(to - from, height);
        camera.setViewOffset(width, height, from, 0, to - from, height);
        const { data } = bench.byTechnique(technique, scene, camera);
        return { from, to, data };
      };
      const half = width / 2;
      // the second is of another width, as tiles at edges are
      const tiles = [tile(0, half + margin), tile(half - margin, width)];
      const columns = (of: { data: Float32Array; from: number; to: number }, from: number, to: number) => {
        const data = new Float32Array((to - from) * height * 4);
        for (let y = 0; y < height; y++) {
          const at = (y * (of.to - of.from) + from - of.from) * 4;
          data.set(of.data.subarray(at, at + (to - from) * 4), y * (to - from) * 4);
        }
        return { width: to - from, height, data };
      };
      const all = { ...whole, from: 0, to: width };
      return {
        technique,
        seam: compareImages(
          columns(tiles[0], half - margin, half + margin),
          columns(tiles[1], half - margin, half + margin),
        ).psnr,
        whole: Math.min(
          compareImages(columns(tiles[0], 0, half), columns(all, 0, half)).psnr,
          compareImages(columns(tiles[1], half, width), columns(all, half, width)).psnr,
        ),
      };
    });
  });
  for (const { technique, seam, whole } of found) {
    test
      .info()
      .annotations.push({ type: 'dB', description: `${technique}: seam ${seam.toFixed(1)}, ${whole.toFixed(1)}` });
    expect.soft(seam, technique).toBeGreaterThan(45);
    expect.soft(whole, technique).toBeGreaterThan(45);
  }
});
