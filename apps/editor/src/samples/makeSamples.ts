import { containerContent, writeContainer } from '@farol/engine/files';
import { animation } from './animation';
import { fire } from './fire';
import { bakedRoom } from './bakedRoom';
import { microshaders } from './microshaders';
import { nightInTheTemple } from './nightInTheTemple';
import { physics } from './physics';
import { prefabs } from './prefabs';
import { scripts } from './scripts';
import { shading } from './shading';
import { surfaces } from './surfaces';
import type { ReadPublic, SampleScene } from './SampleScene';

/** What makes each sample, by the name of its file in `public/scenes`. */
export const sampleMakers: Readonly<Record<string, (readPublic: ReadPublic) => Promise<SampleScene>>> = {
  'night-in-the-temple.farol': nightInTheTemple,
  'fire.json': fire,
  'baked-room.farol': bakedRoom,
  'animation.json': animation,
  'physics.json': physics,
  'scripts.json': scripts,
  'prefabs.json': prefabs,
  'microshaders.json': microshaders,
  'shading.json': shading,
  'surfaces.json': surfaces,
};

/**
 * The bytes of a sample's file, the same in every run: a container where the name ends in '.farol', JSON else.
 * @param readPublic - reads a file below `public`
 * @throws FileError (as a rejection) naming what is wrong with it
 */
export async function makeSample(file: string, readPublic: ReadPublic): Promise<Uint8Array> {
  const scene = await (await sampleMakers[file](readPublic)).build();
  const content = containerContent(scene);
  scene.dispose();
  if (file.endsWith('.farol')) return writeContainer(content);
  return new TextEncoder().encode(`${JSON.stringify(content.file, null, 1)}\n`);
}
