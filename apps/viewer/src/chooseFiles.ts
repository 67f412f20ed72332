import type { FileMap } from '@farol/engine/files';

/** Extensions of models and of the files that they name. */
const endings = '.glb,.gltf,.bin,.obj,.mtl,.stl,.ply,.zip,.png,.jpg,.jpeg,.webp,.tga,.bmp,.ktx2';

/**
 * Asks the user for files, or for a folder with its content.
 *
 * @returns files by path; null when the user cancels
 */
export function chooseFiles(what: 'files' | 'folder'): Promise<FileMap | null> {
  const input = document.createElement('input');
  input.type = 'file';
  if (what === 'folder') input.webkitdirectory = true;
  else {
    input.multiple = true;
    input.accept = endings;
  }
  return new Promise((resolve) => {
    input.addEventListener('change', () => {
      const files = [...(input.files ?? [])];
      resolve(new Map(files.map((file) => [file.webkitRelativePath || file.name, file])));
    });
    input.addEventListener('cancel', () => resolve(null));
    input.click();
  });
}
