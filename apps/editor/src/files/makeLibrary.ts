import { AssetLibrary, type AssetLibraryOptions } from '@farol/engine';

/** A library that loads from no other host but those that the user was asked about. */
export function makeLibrary(options: AssetLibraryOptions): AssetLibrary {
  const library = new AssetLibrary(options);
  library.allowedOrigins = new Set();
  // the meshes of the samples are offered in every scene; a sample, or a file that names some, brings its own by itself
  void import('./sampleMeshes').then(({ registerSceneAssets }) => registerSceneAssets(library));
  return library;
}
