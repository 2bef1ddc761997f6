/** Lends one object again and again, so that calls create no garbage. A nested call gets its own object. */
export class Pool<Item> {
  private spare: Item | undefined

  constructor(private readonly make: () => Item) {}

  take(): Item {
    const item = this.spare ?? this.make()
    this.spare = undefined
    return item
  }

  giveBack(item: Item) {
    this.spare = item
  }
}
