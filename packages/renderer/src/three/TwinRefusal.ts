/** Thrown by the patch of a twin kind that cannot be inserted in the material's shader; three then draws the material. */
export class TwinRefusal extends Error {}
