import { t, tCount } from '@farol/editing';
import { formatMicroShaderXML } from '@farol/renderer/authoring';
import { fileOpen } from 'browser-fs-access';
import type { ReactNode } from 'react';
import { saveFile } from '../../files/saveFile';
import { fetchThesis } from '../../model/surfaces/thesisSurface';
import { useEditor } from '../../ui/EditorContext';
import { MenuButton } from '../../ui/MenuButton';

const fileType = () => ({
  id: 'farol-microshaders',
  description: t('Microshaders'),
  mimeTypes: ['text/xml'],
  extensions: ['.xml'],
});

/** Imports and exports microshaders in the thesis's XML format. */
export function XMLMenu(): ReactNode {
  const editor = useEditor();
  const { microShaders, notices } = editor;
  const importText = async (text: string, name: string): Promise<void> => {
    const { importMicroShaders } = await import('../../files/importMicroShaders');
    const names = await importMicroShaders(editor, text, name);
    if (names === null) return;
    notices.show(
      'info',
      tCount(names.length, 'Imported {count} microshader of {name}', 'Imported {count} microshaders of {name}', {
        name,
      }),
      'file',
    );
    if (names.length > 0) editor.openMicroShader(names[0]);
  };
  const open = async (): Promise<void> => {
    const file = await fileOpen(fileType());
    await importText(await file.text(), file.name);
  };
  const thesis = async (): Promise<void> => {
    await importText(await fetchThesis(), 'thesis.xml');
  };
  const save = async (): Promise<void> => {
    const chunks = microShaders.exported();
    const blob = new Blob([formatMicroShaderXML(chunks)], { type: 'text/xml' });
    await saveFile(blob, { ...fileType(), fileName: 'microshaders.xml' });
    notices.show(
      'info',
      tCount(chunks.length, 'Exported {count} microshader', 'Exported {count} microshaders'),
      'file',
    );
  };
  return (
    <MenuButton
      label={t('Import and export')}
      icon="more"
      iconOnly
      className="button small"
      entries={() => [
        { label: t('Import XML…'), icon: 'open', run: () => editor.attempt(open) },
        { label: t('Import the Phong lights of 2015'), icon: 'open', run: () => editor.attempt(thesis) },
        {
          label: t('Export XML…'),
          help: t('The microshaders of the scene; all, when it has none.'),
          icon: 'save',
          run: () => editor.attempt(save),
        },
      ]}
    />
  );
}
