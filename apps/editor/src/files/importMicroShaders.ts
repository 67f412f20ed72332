import { t } from '@farol/editing';
import { parseMicroShaderXML } from '@farol/renderer/authoring';
import { formatMicroShader, MicroShaderCompileError } from '@farol/renderer/microshaders';
import type { EditorApi } from '../api/EditorApi';
import { checkMicroShaders } from '../microshaders/checkMicroShaders';

/** Error with the compiler's first message, its microshader and line. */
function refusal(file: string, error: unknown): Error {
  const [first] = error instanceof MicroShaderCompileError ? error.entries : [];
  const reason = first
    ? t('{chunk}, line {line}: {message}', {
        chunk: first.chunk ?? t('a chunk'),
        line: first.line,
        message: first.message,
      })
    : error instanceof Error
      ? error.message
      : String(error);
  return new Error(
    t('{file} is not imported, and nothing has changed: {reason}', { file, reason: reason.slice(0, 300) }),
    { cause: error },
  );
}

/**
 * Imports microshaders from XML into the scene, all or none. Each must compile in every program that uses it; the user
 * is asked before existing ones are replaced.
 * @returns their names; null when the user cancelled
 * @throws Error (as a rejection) naming the microshader and the line
 */
export async function importMicroShaders(
  editor: EditorApi,
  text: string,
  file: string,
): Promise<readonly string[] | null> {
  const { microShaders, dialogs, document, viewport } = editor;
  const edits = parseMicroShaderXML(text, file).map((chunk) => ({ name: chunk.name, text: formatMicroShader(chunk) }));
  const { scene } = document;
  const texts = new Map(scene.microShaders.texts);
  for (const edit of edits) texts.set(edit.name, edit.text);
  const names = edits.map(({ name }) => name);
  try {
    await checkMicroShaders(viewport.farol, texts, names);
  } catch (error) {
    throw refusal(file, error);
  }
  const replaced = edits.filter(({ name, text: next }) => {
    return microShaders.names.includes(name) && microShaders.textOf(name) !== next;
  });
  if (replaced.length > 0) {
    const isAgreed = await dialogs.show({
      kind: 'problems',
      title: t('{file} replaces microshaders that are there', { file }),
      text: t('All that uses these microshaders changes; undo takes the import back. It replaces:'),
      problems: replaced.map(({ name }) => ({
        path: name,
        problem: microShaders.isOwn(name)
          ? t('of this scene')
          : microShaders.isChanged(name)
            ? t('built in, edited')
            : t('built in'),
      })),
      action: t('Replace them'),
      listLabel: t('Microshaders'),
    });
    if (!isAgreed) return null;
  }
  if (document.scene !== scene)
    throw new Error(t('{file} is not imported: another scene was opened meanwhile.', { file }));
  microShaders.takeOver(t('Imported {file}', { file }), edits);
  return names;
}
