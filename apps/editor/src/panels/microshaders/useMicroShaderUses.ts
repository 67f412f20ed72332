import { microShaderSources } from '@farol/renderer/microshader-sources';
import { useEffect } from 'react';
import type { EditorApi } from '../../api/EditorApi';
import { MicroShaderUses } from '../../microshaders/MicroShaderUses';
import { useEditor, useSignal } from '../../ui/EditorContext';

const known = new WeakMap<EditorApi, MicroShaderUses>();

/** Finds where microshaders are used, on first use in an editor. Also loads their unprocessed texts. */
export function useMicroShaderUses(): MicroShaderUses {
  const editor = useEditor();
  let uses = known.get(editor);
  if (!uses) {
    const { viewport, document } = editor;
    uses = new MicroShaderUses(viewport.farol, () => document.scene.microShaders.texts);
    known.set(editor, uses);
    editor.microShaders.sources = microShaderSources;
  }
  useSignal(uses.changed);
  // techniques may change: a plugin can add one
  useSignal(editor.viewport.changed);
  useEffect(() => void uses.find());
  return uses;
}
