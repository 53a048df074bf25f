(* The bytes of delimited text as rows: what boundfit reads of a plain file. *)
From Coq Require Import Init.Byte ZArith QArith List.
From Boundfit Require Import Reader.
Import ListNotations.

(* [None]: no number. [Some None]: nothing, or blanks. *)
Definition cell := option (option Q).

Definition separates (delimiter c : byte) : bool :=
  match delimiter, c with
  | x2c, x2c | x3b, x3b | x09, x09 | x7c, x7c => true   (* comma, semicolon, tabulator, bar *)
  | _, _ => false
  end.
Definition close (p : progress) (cells : list cell) (lines : list (list cell)) : list (list cell) :=
  match p, cells with Nothing, [] => lines | _, _ => rev' (finish p :: cells) :: lines end.

(* Lines end with a line feed, before which a carriage return may stand. Lines without a byte do not count. Text with quotes is
   not read. *)
Fixpoint split (delimiter : byte) (t : list byte) (p : progress) (cells : list cell) (lines : list (list cell)) :
    option (list (list cell)) :=
  match t with
  | [] => Some (rev' (close p cells lines))
  | x22 :: _ => None
  | x0a :: t => split delimiter t Nothing [] (close p cells lines)
  | x0d :: ((x0a :: _) as t) => split delimiter t p cells lines
  | c :: t =>
    if separates delimiter c then split delimiter t Nothing (finish p :: cells) lines
    else split delimiter t (next p c) cells lines
  end.

(* The lines whose number from 1 lies in one of the ranges. *)
Fixpoint chosen (ranges : list (Z * Z)) (number : Z) (lines : list (list cell)) : list (list cell) :=
  match lines with
  | [] => []
  | line :: lines =>
    let rest := chosen ranges (number + 1) lines in
    if existsb (fun range => (fst range <=? number)%Z && (number <=? snd range)%Z)%bool ranges then line :: rest else rest
  end.

(* The cells of these columns, from 1; column 0 is always empty. *)
Fixpoint pick (columns : list nat) (line : list cell) : option row :=
  match columns with
  | [] => Some []
  | column :: columns =>
    match nth column (Some None :: line) None, pick columns line with Some v, Some r => Some (v :: r) | _, _ => None end
  end.
Fixpoint pick_all (columns : list nat) (lines : list (list cell)) : option (list row) :=
  match lines with
  | [] => Some []
  | line :: lines => match pick columns line, pick_all columns lines with Some r, Some rows => Some (r :: rows) | _, _ => None end
  end.

(* The rows of pieces of text: behind a header line if there is one, those of the ranges, of each the columns. *)
Definition rows_of (delimiter : byte) (header : bool) (ranges : list (Z * Z)) (columns : list nat) (pieces : list text) :
    option (list row) :=
  match split delimiter (flat_map bytes_of_text pieces) Nothing [] [] with
  | Some lines => pick_all columns (chosen ranges 1 (if header then tl lines else lines))
  | None => None
  end.

(* The same numbers in the same places. *)
Definition same_entry (a b : option Q) := match a, b with Some a, Some b => a == b | None, None => True | _, _ => False end.
Definition same_rows (found : option (list row)) (rows : list row) :=
  match found with Some found => Forall2 (Forall2 same_entry) found rows | None => False end.

Fixpoint all2 {A} (test : A -> A -> bool) (l m : list A) : bool :=
  match l, m with [], [] => true | a :: l, b :: m => (test a b && all2 test l m)%bool | _, _ => false end.
Definition test_entry (a b : option Q) := match a, b with Some a, Some b => Qeq_bool a b | None, None => true | _, _ => false end.
Definition test_rows (found : option (list row)) (rows : list row) :=
  match found with Some found => all2 (all2 test_entry) found rows | None => false end.
Lemma all2_sound {A} (test : A -> A -> bool) (P : A -> A -> Prop) : (forall a b, test a b = true -> P a b) ->
  forall l m, all2 test l m = true -> Forall2 P l m.
Proof.
  intros H. induction l as [| a l IH]; intros [| b m] E; try discriminate; constructor; apply andb_prop in E; destruct E; auto.
Qed.
Theorem same_rows_of found rows : test_rows found rows = true -> same_rows found rows.
Proof.
  destruct found as [found |]; [| discriminate]. apply all2_sound, all2_sound.
  intros [a |] [b |]; try discriminate; [apply Qeq_bool_iff | reflexivity].
Qed.
