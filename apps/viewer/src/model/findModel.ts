import { shortText, t } from '@farol/editing';
import { decodedUri, type FileMap, type GltfJson } from '@farol/engine/files';

/**
 * Path of the model among dropped files: the .glb, .gltf, .obj, .stl or .ply that is nearest to the top folder.
 *
 * @throws Error when there is none, with the names of the dropped files
 */
export function findModel(files: FileMap): string {
  const models = [...files.keys()].filter((path) => /\.(glb|gltf|obj|stl|ply)$/i.test(path));
  models.sort((a, b) => a.split('/').length - b.split('/').length || a.localeCompare(b));
  if (models.length > 0) return models[0];
  const names =
    [...files.keys()]
      .slice(0, 5)
      .map((path) => shortText(path, 60))
      .join(', ') || t('nothing that is a file');
  throw new Error(t('there is no .glb, .gltf, .obj, .stl or .ply among {names}: choose one.', { names }));
}

/** Path in the file map of a `uri` in the glTF at `modelPath`; null for data inside the glTF. */
export function resolveUri(modelPath: string, uri: string): string | null {
  if (/^(data|blob):/i.test(uri)) return null;
  const parts = modelPath.split('/').slice(0, -1);
  for (const part of decodedUri(uri).replaceAll('\\', '/').split('/')) {
    if (part === '..') parts.pop();
    else if (part !== '.' && part !== '') parts.push(part);
  }
  return parts.join('/');
}

/**
 * The dropped file at a path. Files dropped one by one have no folder: if no file has the whole path, one with the same
 * name is used.
 */
export function lookUp(files: FileMap, path: string): File | null {
  const exact = files.get(path);
  if (exact) return exact;
  const name = path.split('/').pop();
  return files.get(name ?? '') ?? null;
}

/** Paths that a glTF names and the dropped files lack. */
export function missingFiles(files: FileMap, modelPath: string, json: GltfJson): string[] {
  const uris = [...(json.buffers ?? []), ...(json.images ?? [])].flatMap(({ uri }) => (uri === undefined ? [] : [uri]));
  const paths = uris.flatMap((uri) => resolveUri(modelPath, uri) ?? []);
  return [...new Set(paths)].filter((path) => !lookUp(files, path));
}
