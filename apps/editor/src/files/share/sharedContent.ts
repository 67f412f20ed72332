import type { Scene } from '@farol/engine';
import { containerContent, type ContainerContent } from '@farol/engine/files';

export interface ShareOptions {
  /** Whether the scripts of the scene go along; default true. Without them components of theirs stay, as data. */
  readonly withScripts?: boolean;
}

/** A scene as it is given away. */
export function sharedContent(scene: Scene, { withScripts = true }: ShareOptions = {}): ContainerContent {
  const { file, files } = containerContent(scene);
  const assets = file.assets.filter(({ type }) => withScripts || type !== 'script');
  return { file: { ...file, assets }, files };
}
