/** Properties of an event's target that tell whether text is typed into it. */
interface TypedInto {
  readonly tagName?: string;
  readonly isContentEditable?: boolean;
}

const takesText = (target: unknown): boolean => {
  const { tagName = '', isContentEditable = false } = (target ?? {}) as TypedInto;
  return isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(tagName);
};

/** Whether a key goes to a text field or a list of choices, also one in an open shadow root, whose host is the event's target. */
export function isTyping(event: { readonly target: unknown; composedPath(): readonly unknown[] }): boolean {
  return takesText(event.composedPath()[0]) || takesText(event.target);
}
