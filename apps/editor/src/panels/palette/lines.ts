/** Number of lines shown in the command palette. */
export const LINES = 60;
