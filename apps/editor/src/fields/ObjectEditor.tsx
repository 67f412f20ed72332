import { t } from '@farol/editing';
import type { ObjectField } from '@farol/engine/fields';
import { type ReactNode, useMemo } from 'react';
import { useEditor, useSignal } from '../ui/EditorContext';
import { SearchSelect, type SearchOption } from '../ui/SearchSelect';
import type { FieldEditorProps } from '../api/FieldEditorProps';

export function ObjectEditor(props: FieldEditorProps<ObjectField>): ReactNode {
  const { field, value, mixed, label, description, disabled, onCommit } = props;
  const { document } = useEditor();
  const revision = useSignal(document.structure);
  const options = useMemo(() => {
    const list: SearchOption[] = [];
    document.scene.traverse(({ id, name }) => list.push({ value: id, label: name }));
    return list;
    // oxlint-disable-next-line react-hooks/exhaustive-deps -- the revision changes with the tree
  }, [document, revision]);
  const placeholder = mixed ? '—' : t(field.noneLabel ?? 'No object');
  return <SearchSelect {...{ value, options, label, description, disabled, placeholder }} onChange={onCommit} />;
}
