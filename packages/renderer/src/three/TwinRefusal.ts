/** Thrown by a kind's patch that cannot be inserted in the material's shader; three then draws the material. */
export class TwinRefusal extends Error {}
