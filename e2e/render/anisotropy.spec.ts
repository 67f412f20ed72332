import { expect, test } from '../support/benchTest';

/**
 * The thesis's figure 4.3: a chess-board that runs to the horizon. Every technique must read its texture with the same
 * derivatives as stock three, at every anisotropy.
 */
test('a chess-board is as clean at the horizon as stock three draws it, by every technique, at every anisotropy', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, techniquesInTurn, three } = window.testPage;
      const board = new Uint8Array(64 * 64 * 4);
      for (let i = 0; i < 64 * 64; i++) {
        const white = ((i >> 5) ^ (i >> 11)) & 1;
        board.set([white * 255, white * 255, white * 255, 255], i * 4);
      }
      const map = new three.DataTexture(board, 64, 64);
      map.wrapS = map.wrapT = three.RepeatWrapping;
      map.repeat.set(60, 60);
      map.magFilter = three.LinearFilter;
      map.minFilter = three.LinearMipmapLinearFilter;
      map.generateMipmaps = true;
      map.colorSpace = three.SRGBColorSpace;
      const scene = new three.Scene();
      const floor = new three.Mesh(new three.PlaneGeometry(120, 120), new three.MeshStandardMaterial({ map }));
      floor.rotation.x = -Math.PI / 2;
      scene.add(floor, new three.AmbientLight(0xffffff, 1), new three.DirectionalLight(0xffffff, 2));
      const lamp = new three.PointLight(0xffffff, 40, 30);
      lamp.position.y = 3;
      scene.add(lamp);
      const camera = new three.PerspectiveCamera(50, width / height, 0.1, 200);
      camera.position.set(3, 1.2, 20);
      camera.lookAt(0, 0.6, 0);
      const bench = new Bench(width, height);
      // how much light and dark is left in a row of pixels far away: a blurred board is grey there
      const contrast = ({ data }: { data: Float32Array }) => {
        const row = Math.floor(height * 0.42);
        let sum = 0;
        for (let x = 1; x < width; x++) {
          sum += Math.abs(data[(row * width + x) * 4] - data[(row * width + x - 1) * 4]);
        }
        return sum / width;
      };
      const stock: Record<number, number> = {};
      const pairs = [];
      const most = bench.webgl.capabilities.getMaxAnisotropy();
      for (const anisotropy of [1, most]) {
        map.anisotropy = anisotropy;
        map.needsUpdate = true;
        const wanted = bench.stock(scene, camera);
        stock[anisotropy] = contrast(wanted);
        for (const technique of techniquesInTurn(2)) {
          const image = bench.byTechnique(technique, scene, camera);
          const { psnr, share } = compareImages(wanted, image);
          pairs.push({ technique, anisotropy, psnr, share, contrast: contrast(image) });
        }
      }
      return { stock, pairs, most };
    },
    [200, 100] as const,
  );
  const { stock, pairs, most } = results;
  expect(most, 'the device filters anisotropically').toBeGreaterThan(1);
  expect(stock[most], 'anisotropy shows').toBeGreaterThan(stock[1] * 1.3);
  for (const { technique, anisotropy, psnr, share, contrast } of pairs) {
    const seen = `${technique}, anisotropy ${anisotropy}: ${psnr.toFixed(1)} dB, ${share}`;
    expect(Math.abs(contrast / stock[anisotropy] - 1), seen).toBeLessThan(0.01);
    // inferred lighting has its light, though not its texture, at half the resolution
    expect(psnr, seen).toBeGreaterThan(technique === 'inferred' ? 50 : 55);
    expect(share, seen).toBeLessThan(technique === 'inferred' ? 1e-2 : 1e-3);
  }
});
