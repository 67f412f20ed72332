import { formatMicroShaderXML } from '@farol/renderer/authoring';
import { fileOpen } from 'browser-fs-access';
import type { ReactNode } from 'react';
import { saveFile } from '../../files/saveFile';
import { useEditor } from '../../ui/EditorContext';
import { MenuButton } from '../../ui/MenuButton';

const fileType = {
  id: 'farol-microshaders',
  description: 'Microshaders',
  mimeTypes: ['text/xml'],
  extensions: ['.xml'],
};

/** Where the thesis's own microshaders are served. */
const THESIS = 'microshaders/thesis.xml';

/** Import and export of microshaders as the thesis's file of XML. */
export function XMLMenu(): ReactNode {
  const editor = useEditor();
  const { microShaders, notices } = editor;
  const take = async (text: string, name: string): Promise<void> => {
    const { importMicroShaders } = await import('../../files/importMicroShaders');
    const names = await importMicroShaders(editor, text, name);
    if (names === null) return;
    notices.show('info', `Imported ${names.length} microshaders of ${name}`, 'file');
    if (names.length > 0) editor.openMicroShader(names[0]);
  };
  const open = async (): Promise<void> => {
    const file = await fileOpen(fileType);
    await take(await file.text(), file.name);
  };
  const thesis = async (): Promise<void> => {
    const response = await fetch(THESIS);
    if (!response.ok)
      throw new Error(`${THESIS}: the server answers ${response.status}; serve the folder public/ too.`);
    await take(await response.text(), 'thesis.xml');
  };
  const save = async (): Promise<void> => {
    const chunks = microShaders.exported();
    const blob = new Blob([formatMicroShaderXML(chunks)], { type: 'text/xml' });
    await saveFile(blob, { ...fileType, fileName: 'microshaders.xml' });
    notices.show('info', `Exported ${chunks.length} microshaders`, 'file');
  };
  return (
    <MenuButton
      label="Import and export"
      icon="more"
      iconOnly
      className="button small"
      entries={() => [
        { label: 'Import XML…', icon: 'open', run: () => editor.attempt(open) },
        { label: "Import the thesis's", icon: 'open', run: () => editor.attempt(thesis) },
        {
          label: 'Export XML…',
          help: 'Those of the scene; all, when it has none.',
          icon: 'save',
          run: () => editor.attempt(save),
        },
      ]}
    />
  );
}
