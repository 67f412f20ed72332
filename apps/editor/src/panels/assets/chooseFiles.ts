import { t } from '@farol/editing';
import { fileOpen } from 'browser-fs-access';
import type { EditorApi } from '../../api/EditorApi';
import { importOnly } from '../../files/importFiles';

const endings = [
  ...['.glb', '.gltf', '.bin', '.fbx', '.obj', '.mtl', '.stl', '.zip', '.ply', '.gz'],
  ...['.tga', '.bmp', '.png', '.jpg', '.jpeg', '.webp', '.hdr', '.exr', '.cube', '.ktx2', '.ies', '.tlt'],
  ...['.mp3', '.ogg', '.wav', '.m4a', '.flac'],
];

/** Opens a file dialog, and imports the chosen files. */
export async function chooseFiles(editor: EditorApi): Promise<void> {
  const files = await fileOpen({
    description: t('Models, textures, environments, sounds'),
    extensions: endings,
    multiple: true,
  });
  await importOnly(editor, new Map(files.map((file) => [file.name, file])));
}
